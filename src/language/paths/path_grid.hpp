#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "language/paths/robot_path.hpp"

namespace mrroc {

/// The bounds that the limits of a path impose at points along it, for PathTiming: cells between nodes of the parameter
/// s. The acceleration of row x is x' d2s/dt2 + x'' (ds/dt)^2, so under a limit a of its norm the greatest d2s/dt2 is a
/// root of a square equation; a fixed share of a is left for it wherever the speed is the highest.
///
/// Around each node time may be stretched by a factor f >= 1: the limits are 1/f, 1/f^2, 1/f^3 of the path's there.
/// Task's thread.
class PathGrid {
 public:
  /// Of d2s/dt2.
  struct Bounds {
    double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
  };

  /// From `begin` to `end` of the path's parameter, which outlives the grid.
  PathGrid(const RobotPath& path, double begin, double end);

  const std::vector<double>& nodes() const noexcept { return nodes_; }
  std::size_t cells() const noexcept { return nodes_.size() - 1; }
  double width(std::size_t cell) const noexcept { return nodes_[cell + 1] - nodes_[cell]; }
  void stretch(std::size_t node, double factor) noexcept { stretch_[node] *= factor; }

  /// The longest time that a limit's jerk needs for a step from its greatest deceleration to its greatest acceleration,
  /// 2 a / j; s.
  double longest_ramp() const noexcept;
  /// The highest ds/dt in a cell, when a step of the acceleration is spread over `window` s.
  double highest_speed(std::size_t cell, double window) const noexcept;
  /// Bounds of d2s/dt2 in a cell, for (ds/dt)^2 = `square`.
  Bounds accelerations(std::size_t cell, double square, double window) const noexcept;

 private:
  /// The data of a point that a limit needs: products of the derivatives of its rows, norm of the third one.
  struct Shape {
    double first_first, first_second, second_second, third;
  };
  double stretch_of(std::size_t cell) const noexcept { return std::max(stretch_[cell], stretch_[cell + 1]); }
  double acceleration(const PathLimit& limit, std::size_t cell, double window) const noexcept;
  template <class Visit>
  void for_shapes(std::size_t cell, Visit visit) const {
    const std::size_t count = limits_->size();
    for (std::size_t i = 0; i < 2 * count; ++i) visit((*limits_)[i % count], shapes_[2 * count * cell + i]);
  }

  const std::vector<PathLimit>* limits_;
  PathPace pace_;
  std::vector<double> nodes_;
  std::vector<double> stretch_;  ///< of time around each node
  std::vector<Shape> shapes_;    ///< by cell, end, limit
};

}  // namespace mrroc
