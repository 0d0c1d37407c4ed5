#pragma once

#include <cstddef>
#include <memory>

#include "mrroc/generator.hpp"
#include "mrroc/robot.hpp"
#include "mrroc/taught_path.hpp"

namespace mrroc {

/// Replays a taught path.
///
///   timed path     along q(s), the cubic spline in joint space through the points at their times (twice continuously
///                  differentiable, no curvature at its ends), with s from the first time to the last, from rest to
///                  rest: ds/dt reaches `speed` in half a second. If a joint's limits require it, ds/dt is lower along
///                  the whole path: `rate()` returns it. The path passes through every point; points within 20 ms and
///                  1e-4 rad or m (of every joint) are merged.
///   places         a joint line from place to place, at rest at each; `speed` is JointLine's.
///
/// The robot first moves to the first point by a joint line. Poses are converted to joints as JointLine's target is,
/// each to the posture nearest to the previous point. Ends on its own at the last point, at rest; after a pause the
/// robot returns to the point where it was interrupted and continues. (The original's `teach_in` replayed; its
/// `spline`.)
class Replay : public Generator {
 public:
  /// `speed` above 0; with places 1e-6 to 1. Throws NonFatalError: invalid_argument (speed, no point, a timed path of
  /// one point, times that do not increase, another number of joints), not_finite, joint_limit.
  Replay(Robot& robot, TaughtPath path, double speed = 1);
  ~Replay() override;
  Replay(Replay&&) noexcept;
  Replay& operator=(Replay&&) noexcept;

  /// Throws NonFatalError (out_of_workspace, joint_limit, motor_limit) for a pose that the robot cannot reach, and the
  /// error with which the EDP would refuse a part of the path.
  void start() override;
  void resume() override;
  bool terminal_condition() override;
  void next_state() override;

  /// Of a timed path, after `start()`: the largest ds/dt, at most `speed`.
  double rate() const noexcept;
  /// Number of points reached.
  std::size_t point() const noexcept;

 private:
  struct Plan;
  void find_joints();

  Robot* robot_;
  TaughtPath path_;
  double speed_;
  std::unique_ptr<Plan> plan_;
};

}  // namespace mrroc
