#include "core/shown_text.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>

#include "core/utf8.hpp"

namespace mrroc::core {

namespace {

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
