#pragma once

#include <optional>
#include <vector>

#include "language/paths/path_grid.hpp"

namespace mrroc {

/// The timing along a part of a robot's path: from rest to rest, nearly as fast as the path's limits of velocity,
/// acceleration and jerk allow.
///
/// First without jerk: on a grid of the parameter s the speed ds/dt is integrated forward and backward with the maximum
/// acceleration and deceleration that velocity and curvature allow, below the speed at which they still allow some (the
/// phase plane of Bobrow, Dubowsky and Gibson, 1985). Then s(t) is averaged over a window T, which bounds the jerk of
/// s: constant speed stays constant, steps of the acceleration become ramps of duration T. Last, the motion is checked
/// in time with the limits of all rows; around each violation the grid is slowed down accordingly, and the computation
/// is repeated. Violations that remain after some rounds are removed by stretching time. The number of these checks
/// depends on the grid, not on the duration.
///
/// Task's thread. The constructor allocates; `at` does not, and never throws.
class PathTiming {
 public:
  /// s and its derivatives by time.
  struct Point {
    double position = 0, speed = 0, acceleration = 0, jerk = 0;
  };

  /// From `begin` to `end`, with nothing between them where the path has a corner. `sample`: the maximum time between
  /// two checks of the limits, s.
  PathTiming(const RobotPath& path, double begin, double end, double sample);
  /// Of a path whose parameter is the time.
  static PathTiming of_time(double begin, double end);

  /// Stretches the motion to `duration` s, which must not be shorter than before: slower everywhere by the same factor.
  void stretch_to(double duration) noexcept {
    if (!(duration_ > 0)) return;
    stretch_ *= duration / duration_;
    duration_ = duration;
  }

  double begin() const noexcept { return begin_; }
  double end() const noexcept { return end_; }
  double duration() const noexcept { return duration_; }
  /// t of 0..duration().
  Point at(double t) const noexcept;
  /// A point where the motion is so much slower than before and after it that a rest there may take less time; nothing
  /// without such a point.
  std::optional<double> slow_place() const noexcept;

 private:
  /// Of the motion without limits of jerk: the parameter from `begin_`, its derivatives, and its integral over time.
  struct Raw {
    double integral = 0, position = 0, speed = 0, acceleration = 0;
  };

  PathTiming(double begin, double end) : begin_(begin), end_(end), duration_(end - begin) {}
  void lead(const PathGrid& grid, double window);
  bool slow_down(const RobotPath& path, PathGrid& grid, double sample) const;
  double unstretched_duration() const noexcept { return times_.back() + window_; }
  Raw raw_at(double t) const noexcept;
  /// Calls `look` with times of the unstretched motion at which limits are to be checked: at most `sample` and a part
  /// of the window apart; on long motions instead several for every cell of the grid. On each piece of the path there
  /// are at least some. Their number is bounded by the grid's size, not by the duration.
  template <class Visit>
  void for_samples(const RobotPath& path, double sample, double per_window, Visit visit) const;
  /// The time at which the unstretched motion passes s.
  double time_of(double s) const noexcept;

  double begin_ = 0, end_ = 0;
  double duration_ = 0;
  double stretch_ = 1;
  double window_ = 0;                                       ///< T, s; 0: the parameter is the time
  std::vector<double> nodes_, speeds_, times_, integrals_;  ///< of the grid; of Raw, at the nodes
  double worst_place_ = 0;                                  ///< s at which time had to be stretched
};

}  // namespace mrroc
