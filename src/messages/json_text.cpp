#include "messages/json_text.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace mrroc::messages {

void append_json(std::string& text, double value) {
  if (!std::isfinite(value)) {
    text += "null";
    return;
  }
  std::array<char, 40> digits{};
  text.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
}

void append_json(std::string& text, const std::string& value) {
  constexpr std::string_view digits = "0123456789abcdef";
  text += '"';
  for (const char character : value) {
    const auto code = static_cast<unsigned char>(character);
    if (character == '"' || character == '\\')
      text.append(1, '\\').append(1, character);
    else if (code < 0x20)
      text.append("\\u00").append(1, digits[code / 16]).append(1, digits[code % 16]);
    else
      text += character;
  }
  text += '"';
}

}  // namespace mrroc::messages
