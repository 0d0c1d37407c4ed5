#pragma once

#include <rapidcheck.h>

#include <cmath>
#include <limits>

namespace mrroc {

/// Evenly distributed over [low, high]; part of the rapidcheck case, so that a failure shrinks and replays.
inline double any_between(double low, double high) {
  constexpr int kSteps = 1 << 30;
  return low + (high - low) * *rc::gen::inRange(0, kSteps) / (kSteps - 1);
}

/// Numbers of every size, infinities and NaN among them.
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

}  // namespace mrroc
