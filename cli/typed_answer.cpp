#include "cli/typed_answer.hpp"

#include <charconv>
#include <cmath>

#include "config/message_text.hpp"
#include "config/operator_answer.hpp"

namespace mrroc::cli {

namespace {

std::string trimmed(const std::string& line) {
  constexpr const char* kBlanks = " \t\r";
  const std::size_t first = line.find_first_not_of(kBlanks);
  return first == std::string::npos ? "" : line.substr(first, line.find_last_not_of(kBlanks) - first + 1);
}

}  // namespace

std::string expected_answer(const config::SensorEntry& sensor) {
  return config::expected_number(config::answers_of(sensor));
}

std::optional<double> read_answer(const config::SensorEntry& sensor, const std::string& line, std::string& refusal) {
  const std::string text = trimmed(line);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool number = error == std::errc{} && end == text.data() + text.size() && std::isfinite(value);
  if (number && config::is_answer(sensor, value)) return value;
  refusal = config::in_quotes(text) + (number ? " is out of range" : " is no number") + ", expected ";
  refusal += expected_answer(sensor);
  return std::nullopt;
}

}  // namespace mrroc::cli
