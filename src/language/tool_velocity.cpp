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

}  // namespace

ToolVelocity::ToolVelocity(Robot& robot, const Eigen::Vector3d& linear, const Eigen::Vector3d& angular,
                           double acceleration)
    : Generator("ToolVelocity"), robot_(&robot) {
  twist_ << linear, angular;
  if (!twist_.allFinite()) throw NonFatalError(ErrorCode::not_finite, "tool velocity of " + robot.name());
  if (!(acceleration > 0) || !std::isfinite(acceleration)) {
    throw NonFatalError(ErrorCode::invalid_argument,
                        "acceleration " + std::to_string(acceleration) + ", expected a finite number above 0");
  }
  ramp_duration_ = std::max(linear.norm(), angular.norm()) / acceleration;
}

void ToolVelocity::start() {
  reference_ = robot_->state().desired_pose;
  fraction_ = 0;
}

void ToolVelocity::next_state() {
  const double dt = robot_->step_duration();
  const double next = ramp_duration_ <= dt ? 1.0 : std::min(1.0, fraction_ + dt / ramp_duration_);
  reference_ = reference_ * exponential(twist_ * (0.5 * (fraction_ + next) * dt));
  // products of rotations drift off the orthonormal matrices
  reference_.linear() = Eigen::Quaterniond(reference_.linear()).normalized().toRotationMatrix();
  fraction_ = next;
  RobotCommand& command = robot_->command();
  command.kind = CommandKind::pose;
  command.pose = reference_;
  command.twist.head<3>() = reference_.linear() * twist_.head<3>() * fraction_;
  command.twist.tail<3>() = reference_.linear() * twist_.tail<3>() * fraction_;
}

}  // namespace mrroc
