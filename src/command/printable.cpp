#include "command/printable.hpp"

#include "core/utf8.hpp"

namespace mrroc::command {

namespace {

bool is_shown(std::uint32_t code, bool keep_lines) noexcept {
  if (code == '\t' || (keep_lines && code == '\n')) return true;
  if (code < 0x20 || (code >= 0x7F && code < 0xA0)) return false;
  const bool direction = code == 0x200E || code == 0x200F || (code >= 0x202A && code <= 0x202E) ||
                         (code >= 0x2066 && code <= 0x2069) || code == 0x061C;
  return !direction && code != 0x2028 && code != 0x2029;
}

std::string escaped(std::string_view text, bool keep_lines) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string shown;
  shown.reserve(text.size());
  while (!text.empty()) {
    const core::Character character = core::first_character(text);
    const std::string_view bytes = text.substr(0, character.size);
    text.remove_prefix(character.size);
    if (character.valid && is_shown(character.code, keep_lines)) {
      shown += bytes;
      continue;
    }
    for (const char byte : bytes) {
      const auto value = static_cast<unsigned char>(byte);
      shown += {'\\', 'x', kDigits[value >> 4U], kDigits[value & 15U]};
    }
  }
  return shown;
}

}  // namespace

std::string printable(std::string_view text) { return escaped(text, false); }

std::string printable_lines(std::string_view text) { return escaped(text, true); }

}  // namespace mrroc::command
