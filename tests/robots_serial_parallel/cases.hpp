#pragma once

#include <rapidcheck.h>

#include "fixture.hpp"

namespace mrroc {

/// Evenly distributed over [low, high]; part of the rapidcheck case, so that a failure shrinks and replays.
inline double any_between(double low, double high) {
  constexpr int kSteps = 1 << 30;
  return low + (high - low) * *rc::gen::inRange(0, kSteps) / (kSteps - 1);
}

/// Within the limits of joints and passive joints.
inline JointVector any_posture() {
  std::mt19937_64 random(static_cast<std::uint64_t>(*rc::gen::inRange(0, 1 << 30)));
  return random_posture(random);
}

/// An upright platform, within the limits or not.
inline serial_parallel::Placement any_placement() {
  return {.swing = any_between(-1.2, 1.2), .tilt = any_between(-1.2, 1.2), .height = any_between(0.1, 0.5)};
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

inline JointVector any_garbage_joints() {
  JointVector joints(6);
  for (int i = 0; i < 6; ++i) joints[i] = any_garbage();
  return joints;
}

}  // namespace mrroc
