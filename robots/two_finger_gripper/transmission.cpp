#include "robots/two_finger_gripper/transmission.hpp"

#include <algorithm>
#include <cmath>

namespace mrroc::two_finger_gripper {

Transmission::Transmission(const Geometry& geometry, double motor) noexcept
    : dead_motor_(dead_centre(geometry)),
      dead_opening_(geometry.opening_at_zero + geometry.opening_slope * dead_motor_ / 2),
      curvature_(geometry.opening_curvature),
      side_(motor < dead_motor_ ? -1 : 1) {}

std::optional<double> Transmission::opening(double motor) const noexcept {
  const double way = motor - dead_motor_;
  const double opening = dead_opening_ + curvature_ * way * way;
  if (!(way * side_ > 0) || !std::isfinite(opening)) return std::nullopt;
  return opening;
}

std::optional<double> Transmission::motor(double opening) const noexcept {
  const double square = (opening - dead_opening_) / curvature_;
  if (!(square > 0) || !std::isfinite(square)) return std::nullopt;
  return dead_motor_ + side_ * std::sqrt(square);
}

double Transmission::ratio(double opening) const noexcept {
  const double square = (opening - dead_opening_) / curvature_;
  return side_ / (2 * curvature_ * std::sqrt(std::max(square, 1.0)));
}

}  // namespace mrroc::two_finger_gripper
