#include "mrroc/generators/tool_velocity.hpp"

#include <algorithm>
#include <cmath>

#include "core/require.hpp"
#include "geometry/moving_pose.hpp"
#include "geometry/rigid_motion.hpp"
#include "language/tool_motion.hpp"
#include "mrroc/task.hpp"

namespace mrroc {

namespace {

constexpr double kRampJerkRate = 10;     // 1/s: the jerk of a ramp is this times its acceleration
constexpr double kStepRounding = 1e-9;   // macrosteps
constexpr double kRampTolerance = 1e-6;  // of the limits
constexpr int kRampSamples = 64;         // of the rate along a ramp

}  // namespace

ToolVelocity::ToolVelocity(Robot& robot, const Eigen::Vector3d& linear, const Eigen::Vector3d& angular,
                           double acceleration)
    : Generator("ToolVelocity"), robot_(&robot), acceleration_(acceleration) {
  target_ << linear, angular;
  if (!target_.allFinite()) throw NonFatalError(ErrorCode::not_finite, "tool velocity of " + robot.name());
  require_above_zero("ToolVelocity", "acceleration", acceleration);
}

void ToolVelocity::start() {
  reference_ = robot_->known_state().desired_pose;
  const OwnMotion motion = in_own_axes(desired_motion(*robot_));
  start_ = motion.twist;
  rate_ = motion.rate;
  const Twist missing = target_ - start_;
  const double change = std::max(missing.head<3>().norm(), missing.tail<3>().norm());
  // from no rate: the steepest slope of u^2 (3 - 2u) is 1.5, its second derivative at the ends is 6
  const double ramp = std::max(1.5 * change / acceleration_, std::sqrt(6 * change / (kRampJerkRate * acceleration_)));
  // in whole macrosteps: a polynomial through a ramp's end would overshoot the velocity, which may be the limit
  const double step = robot_->step_duration();
  double steps = std::ceil(ramp / step - kStepRounding);
  if (!rate_.isZero(0)) {
    while (!gentle(steps * step)) ++steps;
  }
  ramp_ = steps * step;
  time_ = 0;
}

bool ToolVelocity::gentle(double duration) const noexcept {
  const Twist missing = target_ - start_;
  const auto within = [&](const Twist& value, double bound, const Twist& allowed) {
    return value.head<3>().norm() <= std::max(bound, allowed.head<3>().norm()) * (1 + kRampTolerance) &&
           value.tail<3>().norm() <= std::max(bound, allowed.tail<3>().norm()) * (1 + kRampTolerance);
  };
  if (!(duration > 0)) return missing.isZero(0) && within(rate_, kRampTolerance * acceleration_, Twist::Zero());
  for (int i = 1; i < kRampSamples; ++i) {
    const double u = static_cast<double>(i) / kRampSamples;
    const Twist rate = missing * (6 * u * (1 - u) / duration) + rate_ * (1 - u * (4 - 3 * u));
    if (!within(rate, acceleration_, rate_)) return false;
  }
  // the second derivative is linear in u: its norm is greatest at an end
  const Twist first = (6 / duration * missing - 4 * rate_) / duration;
  const Twist last = (2 * rate_ - 6 / duration * missing) / duration;
  return within(first, kRampJerkRate * acceleration_, Twist::Zero()) &&
         within(last, kRampJerkRate * acceleration_, Twist::Zero());
}

void ToolVelocity::next_state() {
  const double before = time_;
  time_ += robot_->step_duration();
  reference_ = reference_ * exp_twist(way(time_) - way(before));
  reference_.linear() = orthonormal(reference_.linear());

  OwnMotion motion{target_, Twist::Zero()};
  if (time_ < ramp_) {
    const double u = time_ / ramp_;
    const Twist missing = target_ - start_;
    motion.twist = start_ + missing * (u * u * (3 - 2 * u)) + rate_ * (time_ * (1 - u) * (1 - u));
    motion.rate = missing * (6 * u * (1 - u) / ramp_) + rate_ * (1 - u * (4 - 3 * u));
  }
  command_motion(robot_->command(), in_base_axes(reference_, motion));
}

Twist ToolVelocity::way(double t) const noexcept {
  const Twist missing = target_ - start_;
  if (t >= ramp_) return start_ * t + missing * (t - 0.5 * ramp_) + rate_ * (ramp_ * ramp_ / 12);
  const double u = t / ramp_;
  return start_ * t + missing * (ramp_ * u * u * u * (1 - 0.5 * u)) +
         rate_ * (t * t * (0.5 - u * (2.0 / 3 - 0.25 * u)));
}

}  // namespace mrroc
