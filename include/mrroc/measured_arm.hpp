#pragma once

#include <vector>

#include "mrroc/types.hpp"

namespace mrroc {

/// How an arm differs from the model of its type, as `mrroc calibrate kinematics` has measured it.
struct MeasuredArm {
  /// rad or m, of each axis: its joint is at what the encoder says plus this. Empty: 0.
  JointVector zeros;
  /// Of each axis: where it is beside its place on the link before, m and rad (a rotation vector), with all joints at
  /// zero: about the point of the axis that is nearest to the flange, in base axes. Empty: 0.
  std::vector<Twist> links;

  explicit operator bool() const noexcept { return zeros.size() != 0 || !links.empty(); }
};

}  // namespace mrroc
