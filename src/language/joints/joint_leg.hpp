#pragma once

#include <memory>

#include "geometry/desired_state.hpp"
#include "mrroc/robot.hpp"

namespace mrroc {

/// A motion in joint space to rest at a target, for `JointLine` and for generators with several such motions:
/// time-optimal under the shares of the limits scaled by speed, speed^2, speed^3 (Ruckig, phase-synchronised). A motion
/// that the EDP would refuse takes longer where that helps (kSlower). Task's thread. Planning does not allocate, so a
/// step may plan the next motion.
///
/// A motion under way continues with the scaled limits if they hold at its start and no axis leaves the range of start,
/// target and the end of its shortest stop. Otherwise it is first slowed down with the shares of the unscaled limits:
/// to the scaled velocities, and to rest for the axes that would still overshoot. So no axis passes its target by more
/// than its shortest braking distance, at any speed.
class JointLeg {
 public:
  /// Allocates. `robot` must outlive it.
  explicit JointLeg(const Robot& robot);
  ~JointLeg();
  JointLeg(JointLeg&&) noexcept;
  JointLeg& operator=(JointLeg&&) noexcept;

  /// From the robot's desired state, in motion or at rest; `speed` as check_speed. Throws NonFatalError:
  /// invalid_argument; the error with which the EDP would refuse the motion (MotionCheck).
  void plan(const JointVector& target, double speed);
  /// From rest at `from`.
  void plan(const JointVector& from, const JointVector& target, double speed);
  double duration() const noexcept;
  /// Whether the end lies at or before `time` (s since the start); sums of step durations are not exact.
  bool over(double time) const noexcept { return time >= duration() - 1e-9; }
  /// The command of a macrostep that ends `time` s after the start.
  void write(double time, RobotCommand& command) const;
  /// The planned state `time` s after the start.
  DesiredState at(double time) const;

 private:
  struct Plan;
  void begin(const DesiredState& start, const JointVector& target);
  void plan_checked(double speed);
  void calculate(double speed);
  [[noreturn]] void throw_no_trajectory() const;
  const Robot* robot_;
  JointVector target_;
  std::unique_ptr<Plan> plan_;
};

}  // namespace mrroc
