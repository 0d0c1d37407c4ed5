#include "edp/moving_pose.hpp"

#include <Eigen/QR>

#include "language/rigid_motion.hpp"

namespace mrroc::edp {
namespace {

/// dJ/dt dq/dt.
Twist jacobian_rate_times_velocity(const ToolKinematics& kinematics, const JointVector& joints,
                                   const JointVector& velocity, double dt) noexcept {
  const JointVector step = velocity * dt;
  return (kinematics.jacobian(joints + step) - kinematics.jacobian(joints - step)) * velocity / (2 * dt);
}

}  // namespace

JointVector joint_velocity_of(const ToolKinematics& kinematics, const JointVector& joints,
                              const Twist& twist) noexcept {
  Jacobian jacobian = kinematics.jacobian(joints);
  // a joint that the inverse keeps would else be moved by the velocities alone
  if (const int kept = kinematics.model().kept_joint(); kept >= 0) jacobian.col(kept).setZero();
  return Eigen::CompleteOrthogonalDecomposition<Jacobian>(jacobian).solve(twist);
}

Pose MovingPose::after(double t) const noexcept {
  Pose later = Pose::Identity();
  later.translation() = pose.translation() + twist.head<3>() * t + rate.head<3>() * (0.5 * t * t);
  later.linear() = rotation_of(twist.tail<3>() * t + rate.tail<3>() * (0.5 * t * t)) * pose.linear();
  return later;
}

MovingPose tool_motion(const ToolKinematics& kinematics, const DesiredState& joints, double dt) noexcept {
  MovingPose tool;
  tool.pose = kinematics.direct(joints.position);
  if (joints.at_rest()) return tool;
  const Jacobian jacobian = kinematics.jacobian(joints.position);
  tool.twist = jacobian * joints.velocity;
  tool.rate =
      jacobian * joints.acceleration + jacobian_rate_times_velocity(kinematics, joints.position, joints.velocity, dt);
  return tool;
}

double joint_motion(const ToolKinematics& kinematics, const JointVector& joints, const MovingPose& tool, double dt,
                    JointVector& velocity, JointVector& acceleration) noexcept {
  velocity = joint_velocity_of(kinematics, joints, tool.twist);
  const JointVector step = velocity * dt;
  acceleration = (joint_velocity_of(kinematics, joints + step, tool.twist + tool.rate * dt) -
                  joint_velocity_of(kinematics, joints - step, tool.twist - tool.rate * dt)) /
                 (2 * dt);
  return (kinematics.jacobian(joints) * velocity - tool.twist).norm();
}

}  // namespace mrroc::edp
