#pragma once

#include <optional>
#include <ruckig/ruckig.hpp>

#include "language/paths/path_timing.hpp"

namespace mrroc {

/// How a robot on its way along a path comes to rest on the path: its parameter s is led to rest with bounded
/// acceleration and jerk (Ruckig), nearly as fast as the path's limits allow from there. The task's thread; allocates
/// nothing and never throws.
class PathBrake {
 public:
  /// From `now` on, to rest before `end`. `sample`: the time between two looks at the limits, s. Nothing when it cannot
  /// be done within the limits.
  static std::optional<PathBrake> find(const RobotPath& path, const PathTiming::Point& now, double end,
                                       double sample) noexcept;

  double duration() const noexcept { return motion_.get_duration(); }
  /// s and its first two derivatives, `t` s of 0..duration() after its begin; later at rest.
  PathTiming::Point at(double t) const noexcept;

 private:
  bool keeps_limits(const RobotPath& path, double sample) const noexcept;

  ruckig::Trajectory<1> motion_;
};

}  // namespace mrroc
