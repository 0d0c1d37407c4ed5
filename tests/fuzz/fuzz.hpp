#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

/// Common parts of the fuzzers. A fuzzer is one file with this one function: libFuzzer calls it with generated inputs,
/// replay_main.cpp with the files of its corpus. It returns 0. A crash, a hang, a leak, a failed `require` and an
/// exception that escapes are findings.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace fuzz {

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// Ends the process, like any other crash, when a law does not hold.
inline void require(bool holds, const char* law) {
  if (holds) return;
  std::fprintf(stderr, "law broken: %s\n", law);
  std::abort();
}

/// Whether `action` refuses its input with an Error, the only exception that it may throw. The error has a text.
template <class Error, class Action>
bool refuses(Action&& action) {
  try {
    std::forward<Action>(action)();
    return false;
  } catch (const Error& error) {
    require(error.what()[0] != '\0', "an error has a text");
    return true;
  }
}

/// Splits an input into values; behind its end every value is 0.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}

  bool empty() const noexcept { return left_ == 0; }
  std::string_view rest() const noexcept { return text_of(data_, left_); }

  template <class T>
  T take() noexcept {
    static_assert(std::is_trivially_copyable_v<T>);
    T value{};
    take(&value, sizeof value);
    return value;
  }

  void take(void* to, std::size_t size) noexcept {
    const std::size_t there = size < left_ ? size : left_;
    if (there > 0) std::memcpy(to, data_, there);
    data_ += there;
    left_ -= there;
  }

  /// Takes all text up to the line "====" and that line; without one, all text.
  std::string_view take_section() noexcept {
    constexpr std::string_view kEnd = "====\n";
    const std::string_view all = rest();
    const std::size_t end = all.find(kEnd);
    const std::size_t taken = end == std::string_view::npos ? left_ : end + kEnd.size();
    data_ += taken;
    left_ -= taken;
    return all.substr(0, end);
  }

 private:
  const std::uint8_t* data_;
  std::size_t left_;
};

}  // namespace fuzz
