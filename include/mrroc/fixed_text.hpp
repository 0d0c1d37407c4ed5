#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace mrroc {

/// Text of at most `Capacity` characters stored inline. Messages and records use it instead of strings, so that copying
/// never allocates. Longer text is cut. Any thread; never throws.
template <std::size_t Capacity>
class FixedText {
 public:
  FixedText() noexcept = default;
  FixedText(std::string_view text) noexcept { assign(text); }  // NOLINT: text is meant to convert

  void assign(std::string_view text) noexcept {
    const std::size_t size = std::min(text.size(), Capacity);
    std::copy_n(text.begin(), size, data_.begin());
    std::fill(data_.begin() + static_cast<std::ptrdiff_t>(size), data_.end(), '\0');
  }
  std::string_view view() const noexcept { return {data_.data()}; }
  bool empty() const noexcept { return data_[0] == '\0'; }
  /// Zero-terminated, `Capacity + 1` bytes.
  const char* c_str() const noexcept { return data_.data(); }
  friend bool operator==(const FixedText& a, const FixedText& b) noexcept { return a.data_ == b.data_; }

 private:
  std::array<char, Capacity + 1> data_{};
};

}  // namespace mrroc
