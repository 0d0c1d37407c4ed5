#include "sim/ur/program_settings.hpp"

#include <algorithm>
#include <charconv>
#include <system_error>

#include "drivers/ur/wrench/flange_wrench.hpp"

namespace mrroc::sim::ur {
namespace {

/// The numbers of the last call of `function`; empty: there is none.
std::vector<double> arguments_of(const std::string& text, const std::string& function) {
  const std::size_t call = text.rfind(function + "(");
  return call == std::string::npos ? std::vector<double>{} : numbers_in(text.substr(call + function.size()));
}

}  // namespace

std::vector<double> numbers_in(const std::string& text) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const char* const end = text.data() + std::min(text.find('\n'), text.size());
  std::vector<double> numbers;
  for (const char* at = text.data(); at < end; ++at) {
    if (!is_digit(*at) && !(*at == '-' && at + 1 < end && (is_digit(at[1]) || at[1] == '.'))) continue;
    double number = 0;
    const auto [after, error] = std::from_chars(at, end, number);
    if (error == std::errc{}) numbers.push_back(number);
    at = std::max(after, at + 1) - 1;
  }
  return numbers;
}

void read_settings(const std::string& text, ProgramSettings& settings) {
  if (const auto payload = arguments_of(text, "set_payload"); !payload.empty()) {
    settings.payload = payload[0];
    settings.payload_centre = settings.tool.translation();  // where the call leaves it out
    if (payload.size() >= 4) settings.payload_centre << payload[1], payload[2], payload[3];
  }
  if (const auto tool = arguments_of(text, "set_tcp"); tool.size() == 6) {
    settings.tool.translation() << tool[0], tool[1], tool[2];
    settings.tool.linear() = mrroc::ur::rotation_of({tool[3], tool[4], tool[5]});
  }
  if (const auto voltage = arguments_of(text, "set_tool_voltage"); !voltage.empty())
    settings.tool_voltage = static_cast<int>(std::clamp(voltage[0], 0.0, 24.0));
}

}  // namespace mrroc::sim::ur
