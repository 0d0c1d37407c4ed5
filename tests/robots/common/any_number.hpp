#pragma once

#include <rapidcheck.h>

#include <cmath>
#include <limits>

#include "mrroc/types.hpp"

namespace mrroc {

/// 0..2^30 - 1, evenly distributed also in small cases; part of the rapidcheck case, so that a failure shrinks and
/// replays.
inline constexpr int kSteps = 1 << 30;
inline int any_step() { return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, kSteps)); }

/// Evenly distributed over [low, high].
inline double any_between(double low, double high) { return low + (high - low) * any_step() / (kSteps - 1); }

/// Numbers of every size, including infinities and NaN.
inline double any_garbage() {
  const double mantissa = any_between(-10, 10);
  switch (*rc::gen::inRange(0, 12)) {
    case 0:
      return std::numeric_limits<double>::quiet_NaN();
    case 1:
      return std::numeric_limits<double>::infinity();
    case 2:
      return -std::numeric_limits<double>::infinity();
    case 3:
      return 0;
    case 4:
    case 5:
      return std::ldexp(mantissa, *rc::gen::inRange(-1060, 1020));
    default:
      return mantissa;
  }
}

inline JointVector any_garbage_joints(Eigen::Index count) {
  JointVector joints(count);
  for (Eigen::Index i = 0; i < count; ++i) joints[i] = any_garbage();
  return joints;
}

}  // namespace mrroc
