#pragma once

#include <Eigen/Core>

namespace mrroc::polycrank {

/// Two cranks that turn about parallel axes, seen along them. With the angles a, counted from the plane's first
/// coordinate, and b, counted from the first crank, the joint between them is at first (cos a, sin a) and the end at
/// first (cos a, sin a) + second (cos(a + b), sin(a + b)). Lengths in m, not zero, of either sign. Any thread; never
/// allocates or throws.
class PlanarPair {
 public:
  PlanarPair(double first, double second) noexcept : first_(first), second_(second) {}

  Eigen::Vector2d joint(double a) const noexcept;
  Eigen::Vector2d end(double a, double b) const noexcept;

  /// The angles (a, b) that bring the end to `point`, rad, with b in [0, pi] for a `bend` of 1 and in [-pi, 0] for -1.
  /// A point out of reach gets the stretched or folded pair that points at it. Where a is free (`folds_onto`), it is
  /// `free_angle`.
  Eigen::Vector2d angles(const Eigen::Vector2d& point, double bend, double free_angle) const noexcept;
  /// Whether cranks of equal lengths bring the end to `point` with any a: on their first axis, within 1e-10 m.
  bool folds_onto(const Eigen::Vector2d& point) const noexcept;

  double longest_reach() const noexcept;
  double shortest_reach() const noexcept;

 private:
  double first_;
  double second_;
};

}  // namespace mrroc::polycrank
