#pragma once

#include "mrroc/tool_kinematics.hpp"

namespace mrroc::edp {

/// Joint velocities for a twist of the tool, damped near a singularity.
struct DampedVelocity {
  JointVector velocity;  ///< rad/s or m/s
  bool damped = false;   ///< a direction of the tool is nearly lost (s_i < e), and its part of the twist is reduced
  bool near = false;     ///< of a singularity: some s_i < kNear e
};

/// A rotation weighs as the motion of a point at this distance from the tool frame's origin, m.
inline constexpr double kTwistLength = 0.25;
/// A direction is nearly lost when the tool is slower along it, at the speed limit of a joint, than this part of its
/// speed along its fastest direction. At home the robots of this project have 1/33 or more.
inline constexpr double kLostPart = 1.0 / 40;

/// Twice the speed at which the damping begins still counts as beside a singularity.
inline constexpr double kNear = 2;

/// The size of a twist, m/s: the norm of (v, kTwistLength w).
double speed_of(const Twist& twist) noexcept;

/// The joint velocity that gives the tool `twist` (in base axes) at `joints`. With
///
///   A = W J,  W = diag(1, 1, 1, kTwistLength, ...),  A A^T = sum_i l_i u_i u_i^T,  w_i = A^T u_i / l_i,
///   s_i = min_j velocity_max_j / |w_ij|   (speed of the tool along u_i when the first joint is at its limit, m/s),
///   e = kLostPart max_i s_i,
///
/// every direction with s_i >= e is followed exactly: when all are, the result is that of `joint_velocity_of`, bit for
/// bit. Of the others the part (s_i / e)^2 is followed, so no direction requires more joint speed than at s_i = e, and
/// none at the singularity itself:
///
///   dq/dt = sum_i min(1, (s_i / e)^2) w_i u_i^T W twist.
///
/// Where the robot has fewer than six joints that follow, `twist` is first replaced by what `joint_velocity_of` makes
/// of it. Damping of the small singular values alone (numerical filtering): A. A. Maciejewski and C. A. Klein,
/// "Numerical filtering for the operation of robotic manipulators through kinematically singular configurations", J.
/// Robotic Systems 5(6), 1988. Any thread; allocates nothing, never throws.
DampedVelocity damped_joint_velocity(const ToolKinematics& kinematics, const JointVector& joints,
                                     const Twist& twist) noexcept;

}  // namespace mrroc::edp
