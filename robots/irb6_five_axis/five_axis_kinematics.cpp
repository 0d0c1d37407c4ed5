#include "robots/irb6_five_axis/five_axis_kinematics.hpp"

#include <cmath>
#include <numbers>

#include "geometry/inverse_tools.hpp"
#include "geometry/rigid_motion.hpp"

namespace mrroc::irb6 {

using Eigen::Vector3d;
using std::numbers::pi;

constexpr double kBehind = 1e-3;  // m, beyond the limits: margin for a projected pose

namespace {

constexpr double kPlane = 1e-6;       // sine of an angle, rounding error
constexpr double kNearColumn = 0.05;  // m: nearer to it a measured position determines the column's angle badly

}  // namespace

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
    const bool vertical = std::hypot(axis.x(), axis.y()) < kPlane;
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

void FiveAxisKinematics::branches(const Pose& flange, const JointVector& near, double behind,
                                  BranchReceiver& receiver) const noexcept {
  if (!is_rigid(flange) || !near.allFinite()) return;
  const Vector3d p = flange.translation(), axis = flange.linear().col(2);
  const double forward_reach = std::hypot(p.x(), p.y());
  const bool vertical = std::hypot(axis.x(), axis.y()) < kPlane;
  const bool above_shoulder = forward_reach < kSingular;
  const double q1 = above_shoulder && vertical ? near[0] : std::atan2(p.y(), p.x());
  if (!above_shoulder || vertical) {
    reach(flange, near, q1, forward_reach, receiver);
    if (forward_reach <= behind + kBehind) reach(flange, near, q1 > 0 ? q1 - pi : q1 + pi, -forward_reach, receiver);
  }
  if (forward_reach < kNearColumn && !vertical) {
    const double column = nearest_angle(std::atan2(axis.y(), axis.x()), near[0], pi);
    for (const double q : {column, column > 0 ? column - pi : column + pi})
      reach(flange, near, q, p.x() * std::cos(q) + p.y() * std::sin(q), receiver);
  }
  if (!above_shoulder || !vertical) return;
  for (int i = 1; i < kFreeSteps && !receiver.found(); ++i)
    reach(flange, near, q1 + (i % 2 == 0 ? i / 2 : -(i + 1) / 2) * (2 * pi / kFreeSteps), forward_reach, receiver);
}

// The posture of a column angle: `forward_reach` is negative behind the column.
void FiveAxisKinematics::reach(const Pose& flange, const JointVector& near, double column, double forward_reach,
                               BranchReceiver& receiver) const noexcept {
  const ArmAxes level(column, 0);
  const Vector3d p = flange.translation(), axis = flange.linear().col(2), x = flange.linear().col(0);
  const double t4 = std::atan2(-axis.z(), axis.dot(level.along));
  const auto arm_joints = plane_.joints(forward_reach, p.z(), t4);
  if (!arm_joints) return;
  const ArmAxes arm(column, t4);
  JointVector q(5);
  q << column, *arm_joints, nearest_angle(std::atan2(-x.dot(arm.side), x.dot(arm.normal)), near[4], 2 * pi);
  receiver.add(q, std::abs(axis.dot(level.side)) <= kPlane && std::abs(p.dot(level.side)) <= kPlane);
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
