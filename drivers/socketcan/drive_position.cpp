#include "drivers/socketcan/drive_position.hpp"

#include <algorithm>
#include <cmath>

namespace mrroc::edp {

namespace {

constexpr std::int64_t kWrap = std::int64_t{1} << 32;

}  // namespace

void DrivePosition::expect() noexcept {
  ++now_.age;
  ++saved_.age;
}

/// An axis that turns for hours crosses the ends of the counter, in small steps; a large step is taken as received.
std::int64_t DrivePosition::unwrapped(std::int64_t raw) noexcept {
  constexpr std::int64_t kSmall = std::int64_t{1} << 24;
  for (const std::int64_t wraps : {now_.wraps - 1, now_.wraps + 1}) {
    if (std::abs(raw + wraps * kWrap - now_.raw) > kSmall) continue;
    now_.wraps = wraps;
    break;
  }
  return raw + now_.wraps * kWrap;
}

void DrivePosition::take(std::int64_t raw, bool homes) noexcept {
  if (!now_.known && lost_) {
    now_.wraps = 0;
    // the counter starts at power-on: until the robot is synchronised, the axis is assumed to be where it was
    if (!absolute_) now_.offset += static_cast<double>(now_.raw - raw) * rad_per_unit_;
    now_.raw = raw;
    lost_ = !absolute_;
  }
  raw = unwrapped(raw);
  now_.increment = now_.known ? (raw - now_.received) / std::max<std::int64_t>(1, now_.age) : 0;
  if (homes && std::abs(raw - now_.raw) > jump_) {
    // the drive has set its origin; the motion within this tick is negligible
    now_.offset -= static_cast<double>(raw - now_.raw) * rad_per_unit_;
    now_.increment = 0;
  }
  now_.raw = now_.received = raw;
  now_.age = 0;
  now_.known = true;
}

void DrivePosition::assume_position(double position) noexcept {
  now_.known = false;
  now_.raw = now_.received = std::llround(units_of(position));
  now_.wraps = (now_.raw + kWrap / 2) >> 32;
}

}  // namespace mrroc::edp
