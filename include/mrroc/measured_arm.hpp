#pragma once

#include <vector>

#include "mrroc/types.hpp"

namespace mrroc {

/// How an arm differs from the model of its type, as `mrroc calibrate kinematics` has measured it.
struct MeasuredArm {
  /// rad or m, of each axis: its joint is at what the encoder says plus this. Empty: 0.
  JointVector zeros = {};
  /// Of each axis: where it is beside its place on the link before, m and rad (a rotation vector), with all joints at
  /// zero: about the point of the axis that is nearest to the flange, in base axes. Empty: 0.
  std::vector<Twist> links = {};
  /// Of each axis: what its gear adds to a reading e of its encoder (rad), (r, c, s): r e + c (cos e - 1) + s sin e,
  /// the error of the ratio and an eccentricity. Empty: 0; of a sliding axis c and s are 0.
  std::vector<Eigen::Vector3d> gears = {};

  explicit operator bool() const noexcept { return zeros.size() != 0 || !links.empty() || !gears.empty(); }
};

}  // namespace mrroc
