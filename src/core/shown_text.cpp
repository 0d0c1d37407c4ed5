#include "core/shown_text.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>

namespace mrroc::core {

namespace {

/// One character at the begin of a text.
struct Character {
  std::size_t size = 1;    ///< bytes
  std::uint32_t code = 0;  ///< Unicode, or the byte
  bool valid = false;      ///< UTF-8
};

/// RFC 3629: no overlong forms, no surrogates, at most U+10FFFF.
Character first_character(std::string_view text) {
  const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned lead = byte(0);
  if (lead < 0x80) return {1, lead, true};
  const std::size_t size = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  const Character broken{1, lead, false};
  if (lead < 0xC2 || lead > 0xF4 || size > text.size()) return broken;
  std::uint32_t code = lead & (0x7FU >> size);
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return broken;
    code = code << 6 | (byte(i) & 0x3FU);
  }
  constexpr std::array<std::uint32_t, 5> kLeast{0, 0, 0x80, 0x800, 0x10000};
  if (code < kLeast[size] || code > 0x10FFFF || (code >= 0xD800 && code <= 0xDFFF)) return broken;
  return {size, code, true};
}

/// Ranges of Unicode whose characters are not visible, or change the direction of those that are. Sorted.
constexpr std::array<std::array<std::uint32_t, 2>, 13> kInvisible{{{0x00, 0x1F},
                                                                   {0x7F, 0xA0},
                                                                   {0xAD, 0xAD},
                                                                   {0x61C, 0x61C},
                                                                   {0x1680, 0x1680},
                                                                   {0x180E, 0x180E},
                                                                   {0x2000, 0x200F},
                                                                   {0x2028, 0x202F},
                                                                   {0x205F, 0x206F},
                                                                   {0x3000, 0x3000},
                                                                   {0xFEFF, 0xFEFF},
                                                                   {0xFFF0, 0xFFFB},
                                                                   {0xE0000, 0xE0FFF}}};

bool is_odd(const Character& character) {
  return !character.valid || std::any_of(kInvisible.begin(), kInvisible.end(), [&](const auto& range) {
    return range[0] <= character.code && character.code <= range[1];
  });
}

std::string name_of(const Character& character) {
  char text[16];
  const bool byte = !character.valid || character.code < 0x80;
  std::snprintf(text, sizeof text, byte ? "\\x%02X" : "U+%04X", static_cast<unsigned>(character.code));
  return text;
}

}  // namespace

std::string shown(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const Character character = first_character(text);
    if (is_odd(character))
      result += name_of(character);
    else
      result += text.substr(0, character.size);
    text.remove_prefix(character.size);
  }
  return result;
}

std::optional<OddCharacter> odd_character(std::string_view text) {
  for (std::size_t column = 1; !text.empty(); ++column) {
    const Character character = first_character(text);
    if (is_odd(character) && character.code != '\t') return OddCharacter{column, name_of(character)};
    text.remove_prefix(character.size);
  }
  return {};
}

}  // namespace mrroc::core
