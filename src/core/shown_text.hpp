#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

/// Text of a file as an error message shows it. Pure functions; any thread.
namespace mrroc::core {

/// `text` in one line that is safe on a terminal and shows every invisible byte: a control byte and a byte that is not
/// UTF-8 become `\x1B`, a character that is a control, a format mark or a blank other than the space becomes `U+00A0`.
/// All other UTF-8 is kept. shown(shown(t)) = shown(t).
std::string shown(std::string_view text);

/// A byte or character of `text` that `shown` writes differently.
struct OddCharacter {
  std::size_t column = 0;  ///< from 1, in characters; a byte that is not UTF-8 counts as one
  std::string text;        ///< as `shown` writes it
};

/// The first one; a tab does not count, because it separates words. Nothing: the text has none.
std::optional<OddCharacter> odd_character(std::string_view text);

}  // namespace mrroc::core
