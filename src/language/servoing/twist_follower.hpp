#pragma once

#include <memory>

#include "geometry/moving_pose.hpp"
#include "mrroc/robot.hpp"

namespace mrroc {

/// The tool's motion for a generator that requests another twist at every step. Each of its six components is brought
/// to the requested value in the shortest time with at most `acceleration` (m/s^2; rad/s^2 for the angular ones) and a
/// jerk of 10 / s times that (Ruckig; in phase where the change allows it, so that a start from rest is straight). A
/// motion under way at the start is first slowed down to the requested twist with the acceleration that the robot's
/// joints allow in this posture, if that is more; the given acceleration applies after that. The pose follows T(t + dt)
/// = T(t) exp(integral of xi over dt). Task's thread; `step` allocates nothing.
class TwistFollower {
 public:
  /// `axes`: the columns, of length 1 and in tool axes, are the axes of the components; a change along one of them
  /// stays exactly on it. Throws NonFatalError(invalid_argument) for an invalid acceleration.
  TwistFollower(Robot& robot, double acceleration, const Eigen::Matrix3d& axes = Eigen::Matrix3d::Identity());
  ~TwistFollower();
  TwistFollower(TwistFollower&&) noexcept;
  TwistFollower& operator=(TwistFollower&&) noexcept;

  /// Begins with the desired motion of the robot: pose, twist and its rate. Throws NonFatalError when its state is
  /// unknown.
  void start();
  /// Writes the robot's command of the next macrostep, at whose end the twist is as close to `wanted` as the limits
  /// allow. Throws NonFatalError(not_finite).
  void step(const Twist& wanted);

  /// Desired values at the end of the commanded motion; the twist in tool axes.
  const Pose& pose() const noexcept { return pose_; }
  const Twist& twist() const noexcept { return motion_.twist; }
  bool at_rest() const noexcept { return motion_.twist.isZero(0) && motion_.rate.isZero(0); }

  static constexpr double kJerkRate = 10;  ///< 1/s: the jerk is this times the acceleration

 private:
  struct Plan;
  /// The limits of all moving components at the same time under the joints' limits.
  void find_brake();
  Robot* robot_;
  Eigen::Matrix3d axes_;
  std::unique_ptr<Plan> plan_;
  Pose pose_ = Pose::Identity();
  OwnMotion motion_;
  double acceleration_;
  bool braking_ = false;  ///< the motion that was under way at the start
  double brake_acceleration_ = 0, brake_jerk_ = 0;
};

}  // namespace mrroc
