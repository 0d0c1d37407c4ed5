#include "config/text/message_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include "core/shown_text.hpp"

namespace mrroc::config {

namespace {

constexpr std::size_t kQuotedLength = 60;

bool starts_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) != 0x80; }

std::string bounded(const std::string& noun, const std::string& min, const std::string& max) {
  if (min.empty() && max.empty()) return noun;
  if (max.empty()) return noun + " of at least " + min;
  if (min.empty()) return noun + " of at most " + max;
  return noun + " from " + min + " to " + max;
}

}  // namespace

std::string number_text(double value) {
  std::array<char, 32> buffer;
  const auto [end, error] =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general);
  return {buffer.data(), end};
}

std::string in_quotes(std::string_view text) {
  const bool cut = text.size() > kQuotedLength;
  std::size_t length = cut ? kQuotedLength : text.size();
  while (cut && length > 0 && !starts_character(text[length])) --length;  // no partial UTF-8 character
  std::string result = "'";
  result += core::shown(text.substr(0, length));
  return result += cut ? "...'" : "'";
}

std::string alternatives(const std::vector<std::string>& choices) {
  if (choices.empty()) return "nothing";
  std::string result = in_quotes(choices.front());
  for (std::size_t i = 1; i < choices.size(); ++i)
    result += (i + 1 == choices.size() ? " or " : ", ") + in_quotes(choices[i]);
  return result;
}

std::string expected_number(Range range) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return bounded("a number", range.min == -infinity ? "" : number_text(range.min),
                 range.max == infinity ? "" : number_text(range.max));
}

std::string expected_integer(std::int64_t min, std::int64_t max) {
  using Limits = std::numeric_limits<std::int64_t>;
  return bounded("an integer", min == Limits::min() ? "" : std::to_string(min),
                 max == Limits::max() ? "" : std::to_string(max));
}

}  // namespace mrroc::config
