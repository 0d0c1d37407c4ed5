#pragma once

#include <memory>

#include "mrroc/robot.hpp"

namespace mrroc {

/// Turns a target that may jump into commands of one robot within its limits: for generators that know only where to,
/// not how.
///
///     class Follow : public Generator {
///       ...
///       void next_state() override { tracker_.to(where()); }
///       Tracker tracker_;  // Tracker tracker_{robot};
///     };
///
/// Every call commands one macrostep from the robot's desired state, in which each axis has a constant jerk. The axis
/// approaches its target in nearly the shortest time that its velocity, acceleration and jerk limits allow (the mean
/// jerk of Ruckig's time-optimal motion over the macrostep, with 0.8 of the jerk limit; Berscheid and Kroeger, RSS
/// 2021), and lands on it exactly: the last macrosteps solve for the target (a least-norm sequence of jerks). A target
/// that jumps at each step is as good as one that rests. Axes are independent of each other: the tool's path between
/// two targets is not straight.
///
/// The object keeps nothing from step to step, so pauses, late commands and errors need no care. It may be used in
/// `next_state()` only. Task's thread; allocates in its constructor, and at the first step of another macrostep length.
class Tracker {
 public:
  /// `speed`, above 0 to 1: of the velocity limits; squared and cubed, of those of acceleration and jerk. `robot` must
  /// outlive it. Throws NonFatalError(invalid_argument) for another speed.
  explicit Tracker(Robot& robot, double speed = 1);
  ~Tracker();
  Tracker(Tracker&&) noexcept;
  Tracker& operator=(Tracker&&) noexcept;

  /// Towards `target`, rad or m, and to rest there. Throws NonFatalError: invalid_argument for another number of
  /// joints, not_finite, joint_limit, motor_limit.
  void to(const JointVector& target);
  /// Towards a target that moves with `velocity`, rad/s or m/s, to which the robot catches up. Without a velocity it
  /// stays behind a moving target, as if the target rested where it is at this step. Also throws
  /// NonFatalError(velocity_limit).
  void to(const JointVector& target, const JointVector& velocity);
  /// Towards the joints of a pose of the tool in the robot's base frame: of all branches within the limits the nearest
  /// one. Throws NonFatalError: not_finite, out_of_workspace and what else the inverse kinematics reports.
  void to(const Pose& target);

  /// The macrostep commanded last ends on the target, and with its velocity.
  bool arrived() const noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace mrroc
