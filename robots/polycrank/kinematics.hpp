#pragma once

#include "mrroc/errors.hpp"
#include "mrroc/types.hpp"
#include "robots/polycrank/geometry.hpp"
#include "robots/polycrank/planar_pair.hpp"

namespace mrroc::polycrank {

/// Joints (rad) <-> flange pose in the base frame, in closed form. Base frame: origin and x along the first axis,
/// forward; z up. Joints q1..q7; every joint is continuous.
///
/// Two planar pairs of cranks in planes at right angles: axes 1, 2, 3 are along x, axes 4, 5, 6 at right angles to it.
/// With the angles f = q1 + q2 + q3 and g = q4 + q5 + q6 and the directions radial = (0, cos f, sin f), side = (0, sin
/// f, -cos f), the elbow group starts at (d1 + d2 + d3, s) with s the end of the shoulder pair (q1, q2) in the y-z
/// plane, reaches t along `radial` and h along x with (t, h) the end of the elbow pair (q4, q5), and goes d4 + d5 + d6
/// along `side`. The flange's z axis is sin g radial - cos g x, and the flange is d7 along it; q7 turns about it, at q7
/// = 0 with the flange's y axis along `side`.
///
/// Redundancy: orientation gives f, g and q7; position gives h and the common reach of the two pairs along `radial`.
/// How they share it is free: t is the elbow pair's share. Any thread; never allocates or throws.
class Kinematics {
 public:
  explicit Kinematics(const Geometry& geometry) noexcept;

  /// Flange pose; finite for finite joints.
  Pose flange(const JointVector& joints) const noexcept;

  /// Joints of a flange pose near `near`, every joint at its nearest revolution. The cost is the sum of squared joint
  /// changes. Start: in closed form, with t moved as little as possible from that of `near` (not at all where a
  /// solution has it) on each of the wrist's branches (f, g, q7) and (f + pi, -g, q7 + pi); of these and of the two
  /// bends of each pair the one of least cost. From there along the curve that holds the flange (`SelfMotion`) to the
  /// least cost in the neighbourhood. So along a path the joints move by the least norm, as J+ times the twist; no pair
  /// stretches while the other one can move; and a closed path does not in general close in the joints. `none`;
  /// `singular` when g is a multiple of pi (f is kept from `near`) or the elbow pair is folded onto its own axis (q4 is
  /// kept); `out_of_workspace` when no joints belong to the pose, it is not a rigid motion within 1e-6 or a value is
  /// not finite (then `joints` is unchanged).
  ErrorCode inverse(const Pose& flange, const JointVector& near, JointVector& joints) const noexcept;

  /// Geometric Jacobian of a point fixed to the flange, `offset` in flange axes, in base axes.
  Jacobian jacobian(const JointVector& joints, const Eigen::Vector3d& offset) const noexcept;

 private:
  bool closed_form(const Pose& flange, const JointVector& near, JointVector& joints) const noexcept;

  PlanarPair shoulder_;
  PlanarPair elbow_;
  std::array<double, kAxes> offsets_;
  double forward_;  // d1 + d2 + d3
  double aside_;    // d4 + d5 + d6
};

}  // namespace mrroc::polycrank
