#pragma once

#include <cstdint>
#include <ctime>
#include <limits>

namespace mrroc::clock {

inline constexpr std::int64_t kSecond = 1'000'000'000;  ///< ns
/// A deadline that never comes.
inline constexpr std::int64_t kForever = std::numeric_limits<std::int64_t>::max();

/// CLOCK_MONOTONIC, ns. Any thread, signal handlers too; no system call (vDSO).
inline std::int64_t monotonic_ns() noexcept {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return now.tv_sec * kSecond + now.tv_nsec;
}

inline timespec to_timespec(std::int64_t ns) noexcept { return {ns / kSecond, ns % kSecond}; }

}  // namespace mrroc::clock
