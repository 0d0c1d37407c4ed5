#pragma once

#include <cstdint>
#include <string_view>

namespace mrroc {

/// FNV-1a, 64 bit: h = (h xor byte) * prime for each byte. Distinguishes texts, files and traces; it is no protection
/// against intent. Any thread; does not allocate. Source: Fowler, Noll, Vo, IETF draft-eastlake-fnv.
class Fnv1a {
 public:
  constexpr Fnv1a& add(unsigned char byte) noexcept {
    value_ = (value_ ^ byte) * 0x100000001b3U;
    return *this;
  }
  constexpr Fnv1a& add(std::string_view text) noexcept {
    for (const char character : text) add(static_cast<unsigned char>(character));
    return *this;
  }
  /// The bytes of `word`, the lowest first.
  constexpr Fnv1a& add(std::uint64_t word) noexcept {
    for (int shift = 0; shift < 64; shift += 8) add(static_cast<unsigned char>(word >> shift & 0xffU));
    return *this;
  }
  constexpr std::uint64_t value() const noexcept { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325U;
};

}  // namespace mrroc
