#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>

namespace mrroc::process {

/// The encoding of a step in a fixed buffer: CDR (XCDR1) as messages::CdrWriter writes it, but appending neither
/// allocates nor throws; excess values are lost. One thread.
class EncodedStep {
  static_assert(std::endian::native == std::endian::little, "the bytes of a number are copied");

 public:
  static constexpr std::size_t kCapacity = 16384;  // bytes: 16 robots of eight axes and 16 sensors

  EncodedStep() = default;
  EncodedStep(const EncodedStep& other) noexcept { *this = other; }
  /// Copies the bytes that are used.
  EncodedStep& operator=(const EncodedStep& other) noexcept {
    if (this == &other) return *this;
    const std::span<const std::byte> used = other.view();
    std::copy(used.begin(), used.end(), bytes_.begin());
    size_ = used.size();
    full_ = other.full_;
    return *this;
  }

  /// Begins again, with the header of the encoding.
  void clear() noexcept {
    std::copy(kHeader.begin(), kHeader.end(), bytes_.begin());
    size_ = kHeader.size();
    full_ = false;
  }
  /// Whether values are lost.
  bool full() const noexcept { return full_; }
  /// Never more than the buffer, even of one in shared memory that a corrupted process changes meanwhile.
  std::span<const std::byte> view() const noexcept {
    const volatile std::size_t& shared = size_;
    const std::size_t size = shared;
    return {bytes_.data(), std::min(size, kCapacity)};
  }

  template <class Number>
  requires std::integral<Number> || std::floating_point<Number> EncodedStep& operator<<(Number value) noexcept {
    const std::size_t padding = (sizeof(Number) - (size_ - kHeader.size()) % sizeof(Number)) % sizeof(Number);
    if (!has_room(padding + sizeof(Number))) return *this;
    std::fill_n(bytes_.begin() + size_, padding, std::byte{0});
    std::memcpy(bytes_.data() + size_ + padding, &value, sizeof(Number));
    size_ += padding + sizeof(Number);
    return *this;
  }
  /// Its length with the final zero, its characters, the zero.
  EncodedStep& operator<<(std::string_view text) noexcept {
    *this << static_cast<std::uint32_t>(text.size() + 1);
    if (!has_room(text.size() + 1)) return *this;
    const std::span<const std::byte> characters = std::as_bytes(std::span(text));
    std::copy(characters.begin(), characters.end(), bytes_.begin() + size_);
    size_ += text.size();
    bytes_[size_++] = std::byte{0};
    return *this;
  }
  /// The number of elements that follow.
  EncodedStep& count(std::size_t elements) noexcept { return *this << static_cast<std::uint32_t>(elements); }

 private:
  static constexpr std::array<std::byte, 4> kHeader{std::byte{0}, std::byte{1}, std::byte{0}, std::byte{0}};

  bool has_room(std::size_t size) noexcept {
    full_ = full_ || size > kCapacity - size_;
    return !full_;
  }

  std::array<std::byte, kCapacity> bytes_{};
  std::size_t size_ = 0;
  bool full_ = false;
};

}  // namespace mrroc::process
