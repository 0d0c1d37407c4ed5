#pragma once

#include <Eigen/Core>
#include <cmath>
#include <numbers>

namespace mrroc::test {

/// The true surface of the board of tasks/engraving, with the formula of its height field in tasks/engraving/board.py:
/// m, at u to the right and v away from the reader.
inline double board_height(double u, double v) {
  return 0.0025 * std::sin(2 * std::numbers::pi * u / 0.16 + 0.8) + 0.9 * v * v + 0.45 * u * v + 0.02 * u;
}

/// Unit normal there, up, in (u, v, height).
inline Eigen::Vector3d board_normal(double u, double v) {
  constexpr double kStep = 1e-6;
  return Eigen::Vector3d((board_height(u - kStep, v) - board_height(u + kStep, v)) / (2 * kStep),
                         (board_height(u, v - kStep) - board_height(u, v + kStep)) / (2 * kStep), 1)
      .normalized();
}

/// Depth of a point of the machine's base frame below the surface, along its normal, m.
inline double board_depth(const Eigen::Vector3d& point) {
  const double u = -point.y(), v = point.x() - 0.05;
  return (board_height(u, v) - 0.551 - point.z()) * board_normal(u, v).z();
}

}  // namespace mrroc::test
