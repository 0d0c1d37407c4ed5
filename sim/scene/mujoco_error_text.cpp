#include "sim/scene/mujoco_error_text.hpp"

#include <cctype>

namespace mrroc::sim {

namespace {

/// A key with its number, as a part of the message: [begin, end) covers the comma before it, too.
struct Mention {
  std::size_t begin, end, number;
};

/// The first `key` that is followed by a whole number.
std::optional<Mention> find(std::string_view text, std::string_view key) {
  for (std::size_t at = text.find(key); at != text.npos; at = text.find(key, at + 1)) {
    std::size_t end = at + key.size();
    if (end < text.size() && text[end] == '-') ++end;  // column = -1
    const std::size_t digits = end;
    std::size_t number = 0;
    for (; end < text.size() && end < digits + 9 && std::isdigit(static_cast<unsigned char>(text[end])) != 0; ++end) {
      number = 10 * number + static_cast<std::size_t>(text[end] - '0');
    }
    if (end == digits) continue;
    const bool after_comma = at >= 2 && text.substr(at - 2, 2) == ", ";
    return Mention{after_comma ? at - 2 : at, end, number};
  }
  return std::nullopt;
}

std::string in_one_line(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const bool space = std::isspace(static_cast<unsigned char>(c)) != 0;
    if (!space) result += c;
    if (space && !result.empty() && result.back() != ' ') result += ' ';
  }
  while (result.ends_with(' ')) result.pop_back();
  return result;
}

}  // namespace

MujocoErrorText parse_mujoco_error(std::string_view message) {
  MujocoErrorText result;
  std::string text(message);
  if (const auto id = find(text, "id = ")) result.id = id->number;
  for (const char* key : {"line = ", "line ", "Line number="}) {
    const auto line = find(text, key);
    if (!line) continue;
    result.line = line->number;
    text.erase(line->begin, line->end - line->begin);
    if (const auto column = find(text, "column = ")) text.erase(column->begin, column->end - column->begin);
    break;
  }
  result.text = in_one_line(text);
  return result;
}

}  // namespace mrroc::sim
