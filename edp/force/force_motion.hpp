#pragma once

#include "edp/command/force_target.hpp"
#include "language/limit_check.hpp"
#include "mrroc/tool_kinematics.hpp"

namespace mrroc::edp {

/// The set-points of a force motion, one by one: the twist of the law at the tool's desired pose
/// (edp/force/force_law.hpp), the joint velocities that belong to it (`damped_joint_velocity`: without parts that are
/// out of the robot's reach or lost in a singularity), scaled down together until none is above kFraction of its limit,
/// followed as fast as acceleration and jerk limits allow (`follow_velocity`). A set-point is given only if a stop from
/// it stays inside the limits.
///
/// Lost is the part of the law's twist that the robot does not follow beside a singularity, be it out of its reach,
/// scaled down or damped:
///   |W (twist - J dq/dt)| / |W twist|, at most 1, with the W of `damped_joint_velocity`;
/// 0 elsewhere.
/// Where it is damped the motion ends with `singular` when more than kLostMost of a twist faster than kLostLeast is
/// lost for longer than kLostTime.
///
/// The twist of the tick before is kept in base axes, so that the law continues smoothly when the tool turns, when a
/// macrostep changes its parameters, and when the robot comes in motion.
///
/// Allocates nothing but in the constructor, never throws; the servo's thread.
class ForceMotion {
 public:
  /// Throws SystemError when an axis has no acceleration or jerk limit.
  ForceMotion(const RobotModel& model, double period) : model_(&model), limits_(model, period) {}
  /// From now on of this model of the same robot.
  void use(const RobotModel& model) noexcept;

  /// A motion begins at `from`, with the twist that the tool has there.
  void start(const DesiredState& from, const Pose& tool) noexcept;
  /// The set-point `dt` s after `desired`, which it replaces. `measured`: axes and origin of a frame that lies at
  /// `mount` in the flange frame. Class `none`; or a non-fatal error, and `desired` stays: a stop from there is safe.
  ErrorReport step(const ForceTarget& target, const Wrench& measured, const Pose& mount, double dt,
                   DesiredState& desired) noexcept;

  /// Of the twist of the last step, 0..1; 0 below 1e-9.
  double lost() const noexcept { return lost_; }

  static constexpr double kFraction = 0.95;
  static constexpr double kLostMost = 0.5;
  static constexpr double kLostLeast = 0.001;  ///< m/s, as `speed_of` a twist
  static constexpr double kLostTime = 0.5;     ///< s

 private:
  ErrorReport too_much_lost() noexcept;

  const RobotModel* model_;
  LimitCheck limits_;
  Twist previous_ = Twist::Zero();  ///< in base axes
  Twist wanted_ = Twist::Zero();    ///< of the law, if nothing had been lost since the start; in base axes
  double lost_ = 0;
  double lost_for_ = 0;  ///< s for which more than kLostMost has been lost
};

}  // namespace mrroc::edp
