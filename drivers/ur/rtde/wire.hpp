#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>
#include <type_traits>

namespace mrroc::ur::rtde {

using Bytes = std::span<const std::uint8_t>;

/// Unsigned integer with as many bits as `T`.
template <class T>
using BitsOf = std::conditional_t<sizeof(T) == 1, std::uint8_t,
                                  std::conditional_t<sizeof(T) == 2, std::uint16_t,
                                                     std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>>>;

/// Takes values in network byte order from the front of `bytes`. The first read beyond the end makes `ok()` false;
/// from then on every value is zero and every text is empty. Allocates nothing, never throws.
class WireReader {
 public:
  explicit WireReader(Bytes bytes) noexcept : rest_(bytes) {}

  template <class T>
  T take() noexcept {
    static_assert(std::is_arithmetic_v<T> && !std::is_same_v<T, bool>);
    BitsOf<T> bits = 0;
    for (const std::uint8_t byte : take_bytes(sizeof(T)))
      bits = static_cast<BitsOf<T>>(BitsOf<T>(bits << 4) << 4) | byte;
    return std::bit_cast<T>(bits);
  }

  /// The next `size` bytes; empty when there are fewer.
  Bytes take_bytes(std::size_t size) noexcept {
    if (size > rest_.size()) {
      ok_ = false;
      rest_ = {};
      return {};
    }
    const Bytes taken = rest_.first(size);
    rest_ = rest_.subspan(size);
    return taken;
  }

  std::string_view take_text(std::size_t size) noexcept {
    const Bytes taken = take_bytes(size);
    return {reinterpret_cast<const char*>(taken.data()), taken.size()};
  }

  std::string_view take_rest() noexcept { return take_text(rest_.size()); }

  bool ok() const noexcept { return ok_; }
  /// Every read was within the bytes, and all of them are taken.
  bool complete() const noexcept { return ok_ && rest_.empty(); }

 private:
  Bytes rest_;
  bool ok_ = true;
};

/// Writes values in network byte order into a fixed memory. A value that does not fit makes `ok()` false and is not
/// written, nor is any later one. Allocates nothing, never throws.
class WireWriter {
 public:
  explicit WireWriter(std::span<std::uint8_t> memory) noexcept : memory_(memory) {}

  template <class T>
  void put(T value) noexcept {
    static_assert(std::is_arithmetic_v<T> && !std::is_same_v<T, bool>);
    const auto bits = std::bit_cast<BitsOf<T>>(value);
    if (!reserve(sizeof(T))) return;
    for (std::size_t i = 0; i < sizeof(T); ++i)
      memory_[size_++] = static_cast<std::uint8_t>(bits >> (8 * (sizeof(T) - 1 - i)));
  }

  void put_bytes(Bytes bytes) noexcept {
    if (bytes.empty() || !reserve(bytes.size())) return;
    std::memcpy(memory_.data() + size_, bytes.data(), bytes.size());
    size_ += bytes.size();
  }

  void put_text(std::string_view text) noexcept {
    put_bytes({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  }

  bool ok() const noexcept { return ok_; }
  std::size_t size() const noexcept { return size_; }

 private:
  bool reserve(std::size_t size) noexcept { return ok_ = ok_ && size <= memory_.size() - size_; }

  std::span<std::uint8_t> memory_;
  std::size_t size_ = 0;
  bool ok_ = true;
};

}  // namespace mrroc::ur::rtde
