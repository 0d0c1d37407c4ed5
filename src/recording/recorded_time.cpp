#include "recording/recorded_time.hpp"

#include <cmath>

namespace mrroc::recording {

namespace {

constexpr std::uint64_t kSecond = 1'000'000'000;  // ns

}  // namespace

std::uint64_t nanoseconds_of(double seconds) noexcept {
  return static_cast<std::uint64_t>(std::llround(seconds * static_cast<double>(kSecond)));
}

messages::builtin_interfaces::Time stamp_at(std::uint64_t time) noexcept {
  messages::builtin_interfaces::Time stamp;
  stamp.sec = static_cast<std::int32_t>(time / kSecond);
  stamp.nanosec = static_cast<std::uint32_t>(time % kSecond);
  return stamp;
}

}  // namespace mrroc::recording
