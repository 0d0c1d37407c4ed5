#include "mrroc/generators/tool_velocity.hpp"

#include <algorithm>
#include <cmath>

#include "language/rigid_motion.hpp"
#include "mrroc/task.hpp"

namespace mrroc {

namespace {

constexpr double kJerkRate = 10;    // 1/s: the jerk of a ramp is this times its acceleration
constexpr double kRounding = 1e-9;  // macrosteps

}  // namespace

ToolVelocity::ToolVelocity(Robot& robot, const Eigen::Vector3d& linear, const Eigen::Vector3d& angular,
                           double acceleration)
    : Generator("ToolVelocity"), robot_(&robot), acceleration_(acceleration) {
  target_ << linear, angular;
  if (!target_.allFinite()) throw NonFatalError(ErrorCode::not_finite, "tool velocity of " + robot.name());
  if (!(acceleration > 0) || !std::isfinite(acceleration)) {
    throw NonFatalError(ErrorCode::invalid_argument,
                        "acceleration " + std::to_string(acceleration) + ", expected a finite number above 0");
  }
}

void ToolVelocity::start() {
  const RobotState& state = robot_->known_state();
  reference_ = state.desired_pose;
  const Twist base = robot_->kinematics().jacobian(state.desired_joints) * state.desired_velocity;
  start_ = turned(reference_.linear().transpose(), base);
  const Twist missing = target_ - start_;
  const double change = std::max(missing.head<3>().norm(), missing.tail<3>().norm());
  // the steepest slope of u^2 (3 - 2u) is 1.5, its second derivative at the ends is 6
  const double ramp = std::max(1.5 * change / acceleration_, std::sqrt(6 * change / (kJerkRate * acceleration_)));
  // in whole macrosteps: a polynomial through a ramp's end would overshoot the velocity, which may be the limit
  const double step = robot_->step_duration();
  ramp_ = step * std::ceil(ramp / step - kRounding);
  time_ = 0;
}

void ToolVelocity::next_state() {
  const double before = time_;
  time_ += robot_->step_duration();
  const Twist missing = target_ - start_;
  const Twist way = start_ * (time_ - before) + missing * (blend_integral(time_) - blend_integral(before));
  reference_ = reference_ * exponential(way);
  reference_.linear() = orthonormal(reference_.linear());

  const double u = ramp_ > 0 ? std::min(time_ / ramp_, 1.0) : 1.0;
  const Twist twist = start_ + missing * (u * u * (3 - 2 * u));
  Twist rate = u < 1 ? Twist(missing * (6 * u * (1 - u) / ramp_)) : Twist::Zero();
  // the tool's axes turn: seen from the base its velocity changes by w x v in addition
  rate.head<3>() += twist.tail<3>().cross(twist.head<3>());
  RobotCommand& command = robot_->command();
  command.kind = CommandKind::pose;
  command.pose = reference_;
  command.twist = turned(reference_.linear(), twist);
  command.twist_rate = turned(reference_.linear(), rate);
}

double ToolVelocity::blend_integral(double t) const noexcept {
  if (t >= ramp_) return t - 0.5 * ramp_;
  const double u = t / ramp_;
  return ramp_ * u * u * u * (1 - 0.5 * u);
}

}  // namespace mrroc
