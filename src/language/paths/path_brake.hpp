#pragma once

#include <optional>
#include <ruckig/ruckig.hpp>

#include "language/paths/path_timing.hpp"

namespace mrroc {

/// Brings a robot to rest on its path: the parameter s stops with bounded acceleration and jerk (Ruckig), nearly as
/// fast as the path's limits allow from there. Task's thread; allocates nothing and never throws.
class PathBrake {
 public:
  /// From `now` on, to rest before `end`. `sample`: the time between two checks of the limits, s. Nothing when this is
  /// impossible within the limits.
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
