#include "language/stops/common_stop.hpp"

#include <algorithm>
#include <cmath>

namespace mrroc {

namespace {

constexpr double kStopShare = 0.8;     // of the limits
constexpr double kLeastBraking = 0.2;  // of the acceleration limit: left where the motion itself takes most of it
constexpr double kSteepest = 3;        // -rate T: beyond it the robots would turn back

/// s: of one joint from velocity v and acceleration a, both >= 0. With the rate 0 it brakes with at most 1.5 v/T + 0.65
/// a and a jerk of 6 v/T^2 + 4.5 a/T.
double shortest(double v, double a, const AxisParameters& axis) noexcept {
  const double braking = std::max(kStopShare * axis.acceleration_max - 0.65 * a, kLeastBraking * axis.acceleration_max);
  const double jerk = kStopShare * axis.jerk_max;
  return std::max(1.5 * v / braking, (4.5 * a + std::sqrt(20.25 * a * a + 24 * v * jerk)) / (2 * jerk));
}

}  // namespace

CommonStop common_stop(const std::vector<Robot*>& robots, double period) noexcept {
  double duration = 0, along = 0, squares = 0;
  for (const Robot* robot : robots) {
    const RobotState& state = robot->state();
    if (state.at_rest()) continue;
    for (Eigen::Index i = 0; i < state.desired_velocity.size(); ++i) {
      const AxisParameters& axis = robot->parameters().axes[static_cast<std::size_t>(i)];
      const double v = state.desired_velocity[i], a = state.desired_acceleration[i];
      duration = std::max(duration, shortest(std::abs(v), std::abs(a), axis));
      along += v * a / (axis.velocity_max * axis.velocity_max);
      squares += v * v / (axis.velocity_max * axis.velocity_max);
    }
  }
  if (!(duration > 0)) return {};
  // robots that brake already rest no later; to robots that gain speed it is part of their way
  const double rate = squares > 0 ? std::min(0.0, along / squares) : 0;
  if (rate < 0) duration = std::min(duration, std::max(kSteepest / -rate, period));
  const double ticks = std::clamp(std::ceil(duration / period), 1.0, 1.0 * kMaxMotionSteps);
  return {static_cast<std::uint16_t>(ticks), std::max(rate, -kSteepest / (ticks * period))};
}

}  // namespace mrroc
