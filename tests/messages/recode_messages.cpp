// Reads lines "TYPE HEX" from the standard input, decodes each message, encodes it again and prints its bytes as HEX,
// or "error: ...". A line "TYPE" alone prints its type hash and the number of bytes of its schema, then the schema.

#include <algorithm>
#include <array>
#include <charconv>
#include <iostream>
#include <stdexcept>
#include <string>

#include "messages/cdr_reader.hpp"
#include "messages/message_table.hpp"

namespace {

using mrroc::messages::MessageType;

const MessageType& type_of(const std::string& name) {
  for (const MessageType& type : mrroc::messages::message_types())
    if (type.name == name) return type;
  throw std::invalid_argument("no message " + name);
}

std::vector<std::byte> bytes_of(const std::string& text) {
  std::vector<std::byte> bytes;
  for (std::size_t i = 0; i + 1 < text.size(); i += 2) {
    unsigned value = 0;
    std::from_chars(text.data() + i, text.data() + i + 2, value, 16);
    bytes.push_back(static_cast<std::byte>(value));
  }
  return bytes;
}

std::string text_of(const std::vector<std::byte>& bytes) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text;
  for (const std::byte byte : bytes) {
    text += digits[std::to_integer<std::size_t>(byte) / 16];
    text += digits[std::to_integer<std::size_t>(byte) % 16];
  }
  return text;
}

std::string answer_to(const std::string& line) try {
  const std::size_t blank = line.find(' ');
  const MessageType& type = type_of(line.substr(0, blank));
  if (blank != std::string::npos) return text_of(type.recode(bytes_of(line.substr(blank + 1))));
  return std::string{type.hash} + " " + std::to_string(type.schema().size()) + "\n" + std::string{type.schema()};
} catch (const mrroc::messages::CdrError& error) {
  return std::string{"error: "} + error.what();
}

}  // namespace

int main() {
  for (std::string line; std::getline(std::cin, line);) std::cout << answer_to(line) << std::endl;
}
