#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace mrroc::process {

/// One line of text in a fixed buffer: appending never allocates and never throws; excess text is cut. Numbers are
/// written in the shortest form that reads back exactly (std::to_chars), independent of the locale.
class TextLine {
 public:
  static constexpr std::size_t kCapacity = 16384;

  void clear() noexcept {
    size_ = 0;
    cut_ = false;
  }
  /// Never more than its buffer, even for a corrupted line in shared memory.
  std::string_view view() const noexcept { return {data_.data(), std::min(size_, kCapacity)}; }
  bool cut() const noexcept { return cut_; }

  TextLine& operator<<(std::string_view text) noexcept {
    for (const char character : text) put(character);
    return *this;
  }
  TextLine& operator<<(double value) noexcept { return number(value); }
  TextLine& operator<<(std::uint64_t value) noexcept { return number(value); }

 private:
  void put(char character) noexcept {
    if (size_ < kCapacity) {
      data_[size_++] = character;
    } else {
      cut_ = true;
    }
  }
  template <class Number>
  TextLine& number(Number value) noexcept {
    const auto result = std::to_chars(data_.data() + size_, data_.data() + kCapacity, value);
    if (result.ec == std::errc{}) {
      size_ = static_cast<std::size_t>(result.ptr - data_.data());
    } else {
      cut_ = true;
    }
    return *this;
  }

  std::array<char, kCapacity> data_{};
  std::size_t size_ = 0;
  bool cut_ = false;
};

}  // namespace mrroc::process
