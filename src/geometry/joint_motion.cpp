#include "geometry/joint_motion.hpp"

#include "geometry/least_norm.hpp"

namespace mrroc {

JointVector joint_velocity_of(const ToolKinematics& kinematics, const JointVector& joints,
                              const Twist& twist) noexcept {
  Jacobian jacobian = kinematics.jacobian(joints);
  // otherwise the velocities alone would move a joint that the inverse keeps
  if (const int kept = kinematics.model().kept_joint(); kept >= 0) jacobian.col(kept).setZero();
  return least_norm_solution(jacobian, twist);
}

MovingPose tool_motion(const ToolKinematics& kinematics, const DesiredState& joints, double dt) noexcept {
  return mrroc::tool_motion(kinematics, joints.position, joints.velocity, joints.acceleration, dt);
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

}  // namespace mrroc
