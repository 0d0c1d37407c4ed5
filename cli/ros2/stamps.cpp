#include "cli/ros2/stamps.hpp"

#include <algorithm>
#include <cmath>

namespace mrroc::cli {

namespace {

constexpr double kDrift = 2e-4;
constexpr std::int64_t kSecond = 1'000'000'000;

messages::builtin_interfaces::Time time_of(std::int64_t ns) {
  messages::builtin_interfaces::Time time;
  const std::int64_t seconds = ns >= 0 ? ns / kSecond : -((-ns + kSecond - 1) / kSecond);
  time.sec = static_cast<std::int32_t>(seconds);
  time.nanosec = static_cast<std::uint32_t>(ns - seconds * kSecond);
  return time;
}

}  // namespace

messages::builtin_interfaces::Time Stamps::of(Tick tick, std::int64_t now) {
  newest_ = std::max(newest_, tick);
  const std::int64_t own = std::llround(static_cast<double>(tick) * period_ * static_cast<double>(kSecond));
  if (simulated_) return time_of(own);
  const auto drift = static_cast<std::int64_t>(kDrift * static_cast<double>(std::max<std::int64_t>(now - seen_, 0)));
  seen_ = now;
  offset_ = offset_ ? std::min(now - own, *offset_ + drift) : now - own;
  return time_of(own + *offset_);
}

messages::builtin_interfaces::Time Stamps::at(std::int64_t now) const {
  if (!simulated_) return time_of(now);
  return time_of(std::llround(static_cast<double>(newest_) * period_ * static_cast<double>(kSecond)));
}

}  // namespace mrroc::cli
