#pragma once

#include "robots/polycrank/planar_pair.hpp"

namespace mrroc::polycrank {

/// q1..q6, rad: three joints about the first axis, three about the axis at right angles to it.
using Cranks = Eigen::Matrix<double, 6, 1>;

/// The curve of crank postures that hold the flange still: both sums f = q1 + q2 + q3 and g = q4 + q5 + q6 are kept,
/// and one pair extends along `radial` by as much as the other one retracts. With the shoulder pair's cranks j, k and
/// the elbow pair's i, m as vectors in their planes, an index r for the component along `radial`, and the cross
/// products v = j x k, w = i x m, the cranks turn along it as
///   (-w k_r, w (j + k)_r, -w j_r, v m_r, -v (i + m)_r, v i_r).
/// Any thread; never allocates or throws.
class SelfMotion {
 public:
  /// The curve through `posture`. The pairs must outlive it.
  SelfMotion(const PlanarPair& shoulder, const PlanarPair& elbow, const Cranks& posture) noexcept;

  /// The posture at which the walk from `posture` along the curve towards `near` ends: the least sum of squared
  /// differences from `near` in the neighbourhood. At most 40 steps of at most 0.5 rad; the flange stays within 1e-13
  /// m.
  Cranks nearest(const Cranks& near) const noexcept;

 private:
  Cranks start(const Cranks& near) const noexcept;
  Cranks direction(const Cranks& q) const noexcept;
  bool come_back(Cranks& q) const noexcept;
  Eigen::Vector3d reach(const Cranks& q) const noexcept;

  const PlanarPair& shoulder_;
  const PlanarPair& elbow_;
  Cranks posture_;
  Eigen::Vector2d radial_;  // y, z
  Eigen::Vector3d reach_;   // of both pairs, base axes
};

}  // namespace mrroc::polycrank
