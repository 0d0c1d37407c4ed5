#pragma once

#include "mrroc/robot.hpp"

/// Motions of frames to second order. Any thread (`desired_motion`: the task's); never allocates or throws.
namespace mrroc {

/// A frame that moves: where it is, its twist and the twist's rate, all in base axes.
struct MovingPose {
  Pose pose = Pose::Identity();
  Twist twist = Twist::Zero();
  Twist rate = Twist::Zero();

  /// Where it is `t` seconds later at this rate, to second order: p + v t + a t^2/2, exp(w t + alpha t^2/2) R.
  Pose after(double t) const noexcept;
};

/// The tool's motion that belongs to a motion of the joints: twist = J dq/dt, rate = J d2q/dt2 + dJ/dt dq/dt, dJ/dt the
/// central difference of J over +-`dt` s along dq/dt.
MovingPose tool_motion(const ToolKinematics& kinematics, const JointVector& position, const JointVector& velocity,
                       const JointVector& acceleration, double dt) noexcept;

/// The tool's motion at the end of what the robot has been commanded.
MovingPose desired_motion(const Robot& robot) noexcept;

/// A twist and its rate, both in the moving frame's own axes.
struct OwnMotion {
  Twist twist = Twist::Zero();
  Twist rate = Twist::Zero();
};

/// (R^T v, R^T w); its rate is that of the components, (R^T a - w x v, R^T alpha), because the axes turn.
OwnMotion in_own_axes(const MovingPose& moving) noexcept;
/// The inverse.
MovingPose in_base_axes(const Pose& pose, const OwnMotion& motion) noexcept;

/// Commands the tool to move so at the macrostep's end.
void command_motion(RobotCommand& command, const MovingPose& motion) noexcept;

}  // namespace mrroc
