#include "robots/irb6/kinematics.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "geometry/inverse_tools.hpp"
#include "geometry/rigid_motion.hpp"

namespace mrroc::irb6 {

using Eigen::Vector3d;
using std::numbers::pi;

constexpr double kBehind = 1e-3;  // m, beyond the limits: margin for a projected pose

Pose Kinematics::flange(const JointVector& joints) const noexcept {
  const ArmAngles angles(joints);
  const ArmAxes arm(joints[0], angles.wrist);
  const double c5 = std::cos(joints[4]), s5 = std::sin(joints[4]);
  const double c6 = std::cos(joints[5]), s6 = std::sin(joints[5]);
  const Vector3d rolled = arm.normal * c5 - arm.side * s5;
  Pose pose = Pose::Identity();
  pose.linear().col(0) = rolled * c6 + arm.along * s6;
  pose.linear().col(1) = arm.along * c6 - rolled * s6;
  pose.linear().col(2) = arm.normal * s5 + arm.side * c5;
  pose.translation() = plane_.end(joints[0], angles);
  return pose;
}

ErrorCode Kinematics::inverse(const Pose& flange, const JointVector& near, JointVector& joints) const noexcept {
  if (!is_rigid(flange) || !near.allFinite()) return ErrorCode::out_of_workspace;
  const Vector3d p = flange.translation();
  const double forward_reach = std::hypot(p.x(), p.y());
  const bool above_shoulder = forward_reach < kSingular;
  const double q1 = above_shoulder ? near[0] : std::atan2(p.y(), p.x());

  // the flange's z axis is sin q5 (cos t4 up + sin t4 forward) + cos q5 sideways
  const ArmAxes level(q1, 0);
  const Vector3d axis = flange.linear().col(2);
  const double forward = axis.dot(level.along), up = axis.z(), sideways = axis.dot(level.side);
  const double sine5 = std::hypot(forward, up);
  const bool rolls_aligned = sine5 < kSingular;

  double least = std::numeric_limits<double>::infinity();
  JointVector best(6);
  for (const double sign : {1.0, -1.0}) {
    const double t4 = rolls_aligned ? ArmAngles(near).wrist : std::atan2(sign * forward, sign * up);
    const auto arm_joints = plane_.joints(forward_reach, p.z(), t4);
    if (!arm_joints) continue;
    const ArmAxes arm(q1, t4);
    JointVector q(6);
    q << q1, *arm_joints, nearest_angle(std::atan2(sign * sine5, sideways), near[4], 2 * pi),
        std::atan2(flange.linear().col(0).dot(arm.along), flange.linear().col(1).dot(arm.along));
    const double change = (q - near).tail<3>().cwiseAbs().sum();
    if (change < least) {
      least = change;
      best = q;
    }
  }
  if (!std::isfinite(least) || !best.allFinite()) return ErrorCode::out_of_workspace;
  joints = best;
  return rolls_aligned || above_shoulder ? ErrorCode::singular : ErrorCode::none;
}

void Kinematics::branches(const Pose& flange, const JointVector& near, double behind,
                          BranchReceiver& receiver) const noexcept {
  if (!is_rigid(flange) || !near.allFinite()) return;
  const Vector3d p = flange.translation();
  const double forward_reach = std::hypot(p.x(), p.y());
  const bool above_shoulder = forward_reach < kSingular;
  const double q1 = above_shoulder ? near[0] : std::atan2(p.y(), p.x());
  const Vector3d axis = flange.linear().col(2);
  const Column column(q1);
  const bool aligned = std::hypot(axis.dot(column.level.along), axis.z()) < kSingular;
  reach(flange, near, column, forward_reach, aligned, receiver);
  if (forward_reach <= behind + kBehind)
    reach(flange, near, Column(q1 > 0 ? q1 - pi : q1 + pi), -forward_reach, aligned, receiver);
  if (!above_shoulder) return;
  for (int i = 1; i < kFreeSteps && !receiver.found(); ++i)
    reach(flange, near, Column(q1 + (i % 2 == 0 ? i / 2 : -(i + 1) / 2) * (2 * pi / kFreeSteps)), forward_reach, false,
          receiver);
}

// The postures of a column angle: `forward_reach` is negative behind the column.
void Kinematics::reach(const Pose& flange, const JointVector& near, const Column& at, double forward_reach,
                       bool aligned, BranchReceiver& receiver) const noexcept {
  const double column = at.angle;
  const ArmAxes& level = at.level;
  const Vector3d axis = flange.linear().col(2);
  const double forward = axis.dot(level.along), up = axis.z(), sideways = axis.dot(level.side);
  const double sine5 = std::hypot(forward, up);
  const auto add = [&](double t4, double q5) {
    const auto arm_joints = plane_.joints(forward_reach, flange.translation().z(), t4);
    if (!arm_joints) return;
    const ArmAxes arm(column, t4);
    JointVector q(6);
    q << column, *arm_joints, nearest_angle(q5, near[4], 2 * pi),
        std::atan2(flange.linear().col(0).dot(arm.along), flange.linear().col(1).dot(arm.along));
    receiver.add(q, true);
  };
  if (!aligned) {
    for (const double sign : {1.0, -1.0})
      add(std::atan2(sign * forward, sign * up), std::atan2(sign * sine5, sideways));
    return;
  }
  const double t4 = ArmAngles(near).wrist, q5 = std::atan2(sine5, sideways);
  add(t4, q5);
  for (int i = 1; i < kFreeSteps && !receiver.found(); ++i)
    add(t4 + (i % 2 == 0 ? i / 2 : -(i + 1) / 2) * (2 * pi / kFreeSteps), q5);
}

Jacobian Kinematics::jacobian(const JointVector& joints, const Eigen::Vector3d& offset) const noexcept {
  const double q1 = joints[0];
  const ArmAngles angles(joints);
  const ArmAxes arm(q1, angles.wrist);
  const Pose pose = flange(joints);
  const Vector3d point = pose * offset, pitch = plane_.wrist_pitch(q1, angles);

  Jacobian j(6, 6);
  const auto column = [&](int i, const Vector3d& axis, const Vector3d& centre) {
    j.col(i) << axis.cross(point - centre), axis;
  };
  column(0, Vector3d::UnitZ(), Vector3d::Zero());
  column(1, arm.side, Vector3d::Zero());
  column(2, arm.side, plane_.elbow(q1, angles));
  column(3, arm.side, pitch);
  column(4, arm.along, pitch);
  column(5, pose.linear().col(2), pose.translation());
  return j;
}

}  // namespace mrroc::irb6
