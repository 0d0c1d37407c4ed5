#pragma once

#include "geometry/desired_state.hpp"
#include "language/tracking/axis_tracker.hpp"
#include "mrroc/joint_trajectory.hpp"

namespace mrroc {

/// A JointTrajectory as one polynomial per axis and piece: piece k leads to point k, from the point before; piece 0, if
/// its point is not at time 0, from the state of the robot at the start. Degree five where accelerations are
/// given, three where velocities are, and where positions alone are: of degree three, with the velocity 0 at a point
/// at which the direction changes, and the weighted harmonic mean of the two slopes at another (Fritsch and Butland,
/// SIAM J. Sci. Stat. Comput. 5, 1984), so that no point is overshot. One thread; allocates nothing, never throws.
class TrajectoryPieces {
 public:
  /// `trajectory` has no problem and outlives the use of the pieces.
  void begin(const JointTrajectory& trajectory, const DesiredState& from) noexcept;

  /// The piece of a time: its ends are before, and not before it. `points()` behind the last point, where all rest.
  std::size_t piece_at(double time) const noexcept;
  /// The polynomial at `time`, also beyond its ends.
  AxisMotion at(std::size_t piece, std::size_t axis, double time) const noexcept;

 private:
  std::size_t first() const noexcept { return trajectory_->time(0) > 0 ? 0 : 1; }
  double time_before(std::size_t piece) const noexcept { return piece == 0 ? 0 : trajectory_->time(piece - 1); }
  double position_before(std::size_t piece, std::size_t axis) const noexcept;
  double slope(std::size_t piece, std::size_t axis) const noexcept;
  /// At a point.
  double velocity(std::size_t point, std::size_t axis) const noexcept;

  const JointTrajectory* trajectory_ = nullptr;
  DesiredState from_;
};

}  // namespace mrroc
