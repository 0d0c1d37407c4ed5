#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace mrroc::core {

/// One character of a text in UTF-8.
struct Character {
  std::size_t size = 1;    ///< bytes
  std::uint32_t code = 0;  ///< Unicode; of a byte that is not UTF-8 the byte
  bool valid = false;      ///< UTF-8: no overlong form, no surrogate, at most U+10FFFF (RFC 3629)
};

/// The first character of `text`, which is not empty. Any thread.
Character first_character(std::string_view text) noexcept;

}  // namespace mrroc::core
