#pragma once

#include "mrroc/tool_kinematics.hpp"

/// Motions of frames to second order. Any thread; never allocates or throws.
namespace mrroc {

/// A moving frame: its pose, its twist and the twist's rate, all in base axes.
struct MovingPose {
  Pose pose = Pose::Identity();
  Twist twist = Twist::Zero();
  Twist rate = Twist::Zero();

  /// The pose `t` seconds later at this rate, to second order: p + v t + a t^2/2, exp(w t + alpha t^2/2) R.
  Pose after(double t) const noexcept;
};

/// The tool's motion that belongs to a motion of the joints: twist = J dq/dt, rate = J d2q/dt2 + dJ/dt dq/dt, dJ/dt the
/// central difference of J over +-`dt` s along dq/dt.
MovingPose tool_motion(const ToolKinematics& kinematics, const JointVector& position, const JointVector& velocity,
                       const JointVector& acceleration, double dt) noexcept;

/// A twist and its rate, both in the moving frame's own axes.
struct OwnMotion {
  Twist twist = Twist::Zero();
  Twist rate = Twist::Zero();
};

/// (R^T v, R^T w); its rate is that of the components, (R^T a - w x v, R^T alpha), because the axes turn.
OwnMotion in_own_axes(const MovingPose& moving) noexcept;
/// The inverse.
MovingPose in_base_axes(const Pose& pose, const OwnMotion& motion) noexcept;

}  // namespace mrroc
