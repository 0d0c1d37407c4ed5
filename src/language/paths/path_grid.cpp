#include "language/paths/path_grid.hpp"

#include <algorithm>
#include <cmath>

namespace mrroc {

namespace {

constexpr double kCurveShare = 0.85;               // of the acceleration: maximum share for the curvature
constexpr double kTwistShare = 0.6;                // of the jerk: maximum share for the third derivative
constexpr int kCells = 400;                        // of a path
constexpr int kFewestCells = 12, kMostCells = 64;  // of a piece

}  // namespace

PathGrid::PathGrid(const RobotPath& path, double begin, double end) : limits_(&path.limits()), pace_(path.pace()) {
  const std::vector<double>& breaks = path.breaks();
  const int pieces = static_cast<int>(breaks.size()) - 1;
  const int most = std::clamp(kCells / std::max(pieces, 1), kFewestCells, kMostCells);
  nodes_.push_back(begin);
  for (std::size_t piece = 0; piece + 1 < breaks.size(); ++piece) {
    const double from = std::max(begin, breaks[piece]), to = std::min(end, breaks[piece + 1]);
    if (!(to > from)) continue;
    const double part = (to - from) / (breaks[piece + 1] - breaks[piece]);
    const int count = std::max(kFewestCells, static_cast<int>(std::ceil(most * part)));
    for (int k = 0; k < count; ++k) {
      for (const int side : {k, k + 1}) {
        const PathRates rates = path.rates(piece, from + (to - from) * side / count);
        for (const PathLimit& limit : *limits_) {
          const auto first = rates.first.segment(limit.row, limit.rows);
          const auto second = rates.second.segment(limit.row, limit.rows);
          shapes_.push_back({first.squaredNorm(), first.dot(second), second.squaredNorm(),
                             rates.third.segment(limit.row, limit.rows).norm()});
        }
      }
      nodes_.push_back(k + 1 < count ? from + (to - from) * (k + 1) / count : to);
    }
  }
  stretch_.assign(nodes_.size(), 1);
}

/// The acceleration that a limit allows in a cell when the window spreads a step of it over `window` s.
double PathGrid::acceleration(const PathLimit& limit, std::size_t cell, double window) const noexcept {
  const double f = stretch_of(cell);
  return std::min(limit.acceleration / (f * f), 0.5 * window * limit.jerk / (f * f * f));
}

double PathGrid::highest_speed(std::size_t cell, double window) const noexcept {
  const double f = stretch_of(cell);
  double speed = pace_.speed / f;
  for_shapes(cell, [&](const PathLimit& limit, const Shape& shape) {
    const auto bound = [&speed](double value) { speed = std::min(speed, value); };
    if (shape.first_first > 0) bound(limit.velocity / (f * std::sqrt(shape.first_first)));
    if (shape.second_second > 0)
      bound(std::sqrt(kCurveShare * acceleration(limit, cell, window) / std::sqrt(shape.second_second)));
    if (shape.third > 0) bound(std::cbrt(kTwistShare * limit.jerk / shape.third) / f);
  });
  return speed;
}

PathGrid::Bounds PathGrid::accelerations(std::size_t cell, double square, double window) const noexcept {
  const double f = stretch_of(cell);
  Bounds bounds{-pace_.acceleration / (f * f), pace_.acceleration / (f * f)};
  for_shapes(cell, [&](const PathLimit& limit, const Shape& shape) {
    // |first a + second v^2| <= limit
    if (shape.first_first > 0) {
      const double most = acceleration(limit, cell, window), mean = shape.first_second * square;
      const double root = std::sqrt(
          std::max(0.0, mean * mean - shape.first_first * (shape.second_second * square * square - most * most)));
      bounds.high = std::min(bounds.high, (root - mean) / shape.first_first);
      bounds.low = std::max(bounds.low, (-root - mean) / shape.first_first);
    }
    // |3 second v a| <= limit
    if (shape.second_second * square > 0) {
      const double most = limit.jerk / (f * f * f * 3 * std::sqrt(shape.second_second * square));
      bounds.high = std::min(bounds.high, most);
      bounds.low = std::max(bounds.low, -most);
    }
  });
  return bounds;
}

double PathGrid::longest_ramp() const noexcept {
  double window = 0;
  for (std::size_t i = 0; i < limits_->size(); ++i) {
    const PathLimit& limit = (*limits_)[i];
    bool moves = false;
    for (std::size_t k = i; k < shapes_.size() && !moves; k += limits_->size()) moves = shapes_[k].first_first > 0;
    if (moves) window = std::max(window, 2 * limit.acceleration / limit.jerk);
  }
  return window;
}

}  // namespace mrroc
