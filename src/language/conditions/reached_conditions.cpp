// Conditions on the positions of the tool and the joints: PositionReached, JointsReached, PathTravelled.
#include <cmath>

#include "core/require.hpp"
#include "core/short_number.hpp"
#include "geometry/rigid_motion.hpp"
#include "mrroc/conditions/path_travelled.hpp"
#include "mrroc/conditions/position_reached.hpp"

namespace mrroc {

PositionReached::PositionReached(const Robot& robot, const Eigen::Vector3d& position, double tolerance)
    : Condition(robot.name() + " within " + short_number(tolerance) + " m of its place"),
      robot_(&robot),
      tolerance_(tolerance) {
  require_above_zero("PositionReached", "tolerance", tolerance);
  if (!position.allFinite()) throw NonFatalError(ErrorCode::not_finite, "place of PositionReached");
  pose_.translation() = position;
}

PositionReached::PositionReached(const Robot& robot, const Pose& pose, double tolerance, double angle)
    : PositionReached(robot, Eigen::Vector3d{pose.translation()}, tolerance) {
  require_above_zero("PositionReached", "angle", angle);
  if (!is_rigid(pose)) throw NonFatalError(ErrorCode::invalid_argument, "PositionReached: the pose is not rigid");
  pose_ = pose;
  angle_ = angle;
}

bool PositionReached::holds() {
  const Pose& now = robot_->state().pose;
  return (now.translation() - pose_.translation()).norm() <= tolerance_ &&
         (std::isinf(angle_) || rotation_vector(pose_.linear().transpose() * now.linear()).norm() <= angle_);
}

JointsReached::JointsReached(const Robot& robot, const JointVector& joints, double tolerance)
    : Condition(robot.name() + " joints within " + short_number(tolerance)),
      robot_(&robot),
      joints_(joints),
      tolerance_(tolerance) {
  require_above_zero("JointsReached", "tolerance", tolerance);
  if (!joints.allFinite()) throw NonFatalError(ErrorCode::not_finite, "joints of JointsReached");
  if (static_cast<std::size_t>(joints.size()) != robot.parameters().axes.size()) {
    throw NonFatalError(ErrorCode::invalid_argument, "JointsReached: " + std::to_string(joints.size()) +
                                                         " joints, expected " +
                                                         std::to_string(robot.parameters().axes.size()));
  }
}

bool JointsReached::holds() {
  const JointVector& now = robot_->state().joints;
  return now.size() == joints_.size() && (now - joints_).lpNorm<Eigen::Infinity>() <= tolerance_;
}

PathTravelled::PathTravelled(const Robot& robot, double length)
    : Condition("a way of " + short_number(length) + " m"), robot_(&robot), length_(length) {
  require_above_zero("PathTravelled", "length", length);
}

void PathTravelled::start() {
  way_ = 0;
  last_ = robot_->state().pose.translation();
}

bool PathTravelled::holds() {
  const Eigen::Vector3d now = robot_->state().pose.translation();
  way_ += (now - last_).norm();
  last_ = now;
  return way_ >= length_;
}

}  // namespace mrroc
