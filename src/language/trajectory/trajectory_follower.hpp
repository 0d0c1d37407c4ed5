#pragma once

#include <vector>

#include "language/limit_check.hpp"
#include "language/trajectory/time_ramp.hpp"
#include "language/trajectory/trajectory_pieces.hpp"
#include "mrroc/joint_trajectory.hpp"
#include "mrroc/robot.hpp"
#include "mrroc/tracker.hpp"

namespace mrroc {

/// Moves a robot along a JointTrajectory, a macrostep at a time. With the reference r(t) of the piece in which the
/// macrostep ends, and the deviation d = desired - r at its start, the command is r + d' at its end, where d' is one
/// period of each axis on its way to d = 0 (AxisTracker) within what the reference leaves of the limits: 0 on the
/// trajectory. If LimitCheck, the EDP's own, refuses that, a `Tracker` follows the reference. Task's thread; allocates
/// in its constructor only.
class TrajectoryFollower {
 public:
  explicit TrajectoryFollower(Robot& robot);

  /// Class `none`, or why the robot cannot follow it from its desired state. The trajectory has no problem.
  ErrorReport check(const JointTrajectory& trajectory) const noexcept;
  /// Takes a trajectory without a problem, in exchange for the last one.
  void begin(JointTrajectory& trajectory) noexcept;
  /// From now on the steps lead to rest on the trajectory, until `go_on` leads from rest to its full speed.
  void brake() noexcept;
  void go_on() noexcept;
  void step();

  /// The last command is the end of the trajectory, or after `brake` a point of it, at rest.
  bool at_end() const noexcept { return landed_ && time_ >= trajectory_.duration(); }
  bool at_rest() const noexcept { return landed_ && ramp_.over() && ramp_.goal() == 0; }
  /// Time on it at the end of the last command, s; beyond its duration it continues.
  double time() const noexcept { return time_; }
  const JointTrajectory& trajectory() const noexcept { return trajectory_; }
  /// The axis whose measured position is beyond the path tolerance, and by how much it is off; -1: none.
  int off_path(double& distance) const noexcept;
  /// The same of the goal tolerance at the last point.
  int off_goal(double& distance) const noexcept;

 private:
  bool command_exactly(double own_step, TimeScale before);
  void track();
  bool is_allowed(const DesiredState& to) noexcept;
  double ramp_duration(const JointVector& speed) const noexcept;

  Robot* robot_;
  JointTrajectory trajectory_;
  TrajectoryPieces pieces_;
  TimeRamp ramp_;
  LimitCheck limits_;
  Tracker tracker_;
  double step_;
  std::vector<AxisTracker> axes_;
  DesiredState reference_, goal_;
  double time_ = 0;
  bool landed_ = false;
};

}  // namespace mrroc
