#include "mrroc/generators/tool_velocity.hpp"

#include <algorithm>
#include <cmath>

#include "mrroc/task.hpp"

namespace mrroc {

namespace {

/// exp of a twist (times seconds) in body axes: the displacement of a constant screw motion (Lynch and Park, Modern
/// Robotics, eq. 3.88).
Pose exponential(const Twist& displacement) {
  const Eigen::Vector3d linear = displacement.head<3>();
  const Eigen::Vector3d angular = displacement.tail<3>();
  Pose pose = Pose::Identity();
  const double angle = angular.norm();
  if (angle < 1e-12) {
    pose.translation() = linear;
    return pose;
  }
  const Eigen::Vector3d axis = angular / angle;
  pose.linear() = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
  const Eigen::Vector3d v = linear / angle;
  pose.translation() =
      v * angle + (1 - std::cos(angle)) * axis.cross(v) + (angle - std::sin(angle)) * axis.cross(axis.cross(v));
  return pose;
}

/// The same twist in axes turned by `rotation`.
Twist turned(const Eigen::Matrix3d& rotation, const Twist& twist) {
  Twist result;
  result << rotation * twist.head<3>(), rotation * twist.tail<3>();
  return result;
}

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
  twist_ = turned(reference_.linear().transpose(), base);
}

void ToolVelocity::next_state() {
  const double dt = robot_->step_duration();
  const Twist missing = target_ - twist_;
  const double ramp_duration = std::max(missing.head<3>().norm(), missing.tail<3>().norm()) / acceleration_;
  const Twist next = ramp_duration <= dt ? target_ : Twist(twist_ + missing * (dt / ramp_duration));
  reference_ = reference_ * exponential(0.5 * (twist_ + next) * dt);
  // products of rotations drift off the orthonormal matrices
  reference_.linear() = Eigen::Quaterniond(reference_.linear()).normalized().toRotationMatrix();
  twist_ = next;
  RobotCommand& command = robot_->command();
  command.kind = CommandKind::pose;
  command.pose = reference_;
  command.twist = turned(reference_.linear(), twist_);
}

}  // namespace mrroc
