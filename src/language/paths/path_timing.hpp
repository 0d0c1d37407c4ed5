#pragma once

#include <optional>
#include <vector>

#include "language/paths/path_grid.hpp"

namespace mrroc {

/// When a robot is where on a part of its path: from rest to rest, as fast as the path's limits of velocity,
/// acceleration and jerk allow, nearly.
///
/// First without jerk: on a grid of the parameter s the speed ds/dt is led forward and backward with the greatest
/// acceleration and deceleration that velocity and curvature leave, under the speed at which they leave a rest of it
/// (the phase plane of Bobrow, Dubowsky and Gibson, 1985). Then s(t) is averaged over a window
/// T, which bounds the jerk of s: constant speed stays constant, steps of the acceleration become ramps of duration T.
/// Last the whole is looked at in time, with the limits of all rows; around what is over a limit the grid is made
/// slower by as much, and all is done again. What is left after some rounds is healed by stretching time.
/// The number of these checks depends on the grid, not on the duration.
///
/// Task's thread. The constructor allocates; `at` does not, and never throws.
class PathTiming {
 public:
  /// s and its derivatives by time.
  struct Point {
    double position = 0, speed = 0, acceleration = 0, jerk = 0;
  };

  /// From `begin` to `end`, with nothing between them where the path has a corner. `sample`: the time between two looks
  /// at the limits, at most, s.
  PathTiming(const RobotPath& path, double begin, double end, double sample);
  /// Of a path whose parameter is the time.
  static PathTiming of_time(double begin, double end);

  /// From now on the motion takes `duration` s, which is not shorter than it was: slower everywhere by the same factor.
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
  /// Where the motion is so much slower than before and after that a rest there may take less time; nothing when there
  /// is no such place.
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
  /// are at least some. Their number is bounded by the grid's size, whatever the duration.
  template <class Look>
  void for_looks(const RobotPath& path, double sample, double per_window, Look look) const;
  /// When the unstretched motion passes s.
  double time_of(double s) const noexcept;

  double begin_ = 0, end_ = 0;
  double duration_ = 0;
  double stretch_ = 1;
  double window_ = 0;                                       ///< T, s; 0: the parameter is the time
  std::vector<double> nodes_, speeds_, times_, integrals_;  ///< of the grid; of Raw, at the nodes
  double worst_place_ = 0;                                  ///< s, where time had to be stretched for
};

}  // namespace mrroc
