#include "geometry/moving_pose.hpp"

#include "geometry/rigid_motion.hpp"

namespace mrroc {

namespace {

bool is_zero(const JointVector& joints) noexcept { return (joints.array() == 0.0).all(); }

}  // namespace

Pose MovingPose::after(double t) const noexcept {
  Pose later = Pose::Identity();
  later.translation() = pose.translation() + twist.head<3>() * t + rate.head<3>() * (0.5 * t * t);
  later.linear() = exp_rotation(twist.tail<3>() * t + rate.tail<3>() * (0.5 * t * t)) * pose.linear();
  return later;
}

MovingPose tool_motion(const ToolKinematics& kinematics, const JointVector& position, const JointVector& velocity,
                       const JointVector& acceleration, double dt) noexcept {
  MovingPose tool;
  tool.pose = kinematics.direct(position);
  if (is_zero(velocity) && is_zero(acceleration)) return tool;
  const Jacobian jacobian = kinematics.jacobian(position);
  const JointVector step = velocity * dt;
  tool.twist = jacobian * velocity;
  tool.rate = jacobian * acceleration +
              (kinematics.jacobian(position + step) - kinematics.jacobian(position - step)) * velocity / (2 * dt);
  return tool;
}

OwnMotion in_own_axes(const MovingPose& moving) noexcept {
  const Eigen::Matrix3d back = moving.pose.linear().transpose();
  OwnMotion own{rotate_twist(back, moving.twist), rotate_twist(back, moving.rate)};
  own.rate.head<3>() -= own.twist.tail<3>().cross(own.twist.head<3>());
  return own;
}

MovingPose in_base_axes(const Pose& pose, const OwnMotion& motion) noexcept {
  Twist rate = motion.rate;
  rate.head<3>() += motion.twist.tail<3>().cross(motion.twist.head<3>());
  return {pose, rotate_twist(pose.linear(), motion.twist), rotate_twist(pose.linear(), rate)};
}

}  // namespace mrroc
