#include "robots/irb6_five_axis/five_axis_kinematics.hpp"

#include <cmath>
#include <numbers>

#include "language/inverse_tools.hpp"
#include "language/rigid_motion.hpp"

namespace mrroc::irb6 {

using Eigen::Vector3d;
using std::numbers::pi;

Pose FiveAxisKinematics::flange(const JointVector& joints) const noexcept {
  const ArmAngles angles(joints);
  const ArmAxes arm(joints[0], angles.wrist);
  const double c5 = std::cos(joints[4]), s5 = std::sin(joints[4]);
  Pose pose = Pose::Identity();
  pose.linear().col(0) = arm.normal * c5 - arm.side * s5;
  pose.linear().col(1) = -arm.normal * s5 - arm.side * c5;
  pose.linear().col(2) = arm.along;
  pose.translation() = plane_.end(joints[0], angles);
  return pose;
}

ErrorCode FiveAxisKinematics::inverse(const Pose& flange, const JointVector& near, JointVector& joints) const noexcept {
  if (!is_rigid(flange) || !near.allFinite()) return ErrorCode::out_of_workspace;
  const Vector3d p = flange.translation(), axis = flange.linear().col(2);
  const double forward_reach = std::hypot(p.x(), p.y());
  const bool above_shoulder = forward_reach < kSingular;
  double q1 = std::atan2(p.y(), p.x());
  if (above_shoulder) {
    const bool vertical = std::hypot(axis.x(), axis.y()) < kPlaneTolerance;
    q1 = vertical ? near[0] : nearest_angle(std::atan2(axis.y(), axis.x()), near[0], pi);
  }
  const ArmAxes level(q1, 0);
  if (std::abs(axis.dot(level.side)) > kPlaneTolerance) return ErrorCode::out_of_workspace;
  const double t4 = std::atan2(-axis.z(), axis.dot(level.along));
  const auto arm_joints = plane_.joints(forward_reach, p.z(), t4);
  if (!arm_joints) return ErrorCode::out_of_workspace;
  const ArmAxes arm(q1, t4);
  const Vector3d x = flange.linear().col(0);
  JointVector q(5);
  q << q1, *arm_joints, nearest_angle(std::atan2(-x.dot(arm.side), x.dot(arm.normal)), near[4], 2 * pi);
  if (!q.allFinite()) return ErrorCode::out_of_workspace;
  joints = q;
  return above_shoulder ? ErrorCode::singular : ErrorCode::none;
}

Jacobian FiveAxisKinematics::jacobian(const JointVector& joints, const Vector3d& offset) const noexcept {
  const double q1 = joints[0];
  const ArmAngles angles(joints);
  const ArmAxes arm(q1, angles.wrist);
  const Vector3d point = flange(joints) * offset, pitch = plane_.wrist_pitch(q1, angles);
  Jacobian j(6, 5);
  const auto column = [&](int i, const Vector3d& axis, const Vector3d& centre) {
    j.col(i) << axis.cross(point - centre), axis;
  };
  column(0, Vector3d::UnitZ(), Vector3d::Zero());
  column(1, arm.side, Vector3d::Zero());
  column(2, arm.side, plane_.elbow(q1, angles));
  column(3, arm.side, pitch);
  column(4, arm.along, pitch);
  return j;
}

}  // namespace mrroc::irb6
