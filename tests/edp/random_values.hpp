#pragma once

#include <rapidcheck.h>

#include "geometry/desired_state.hpp"

namespace mrroc::edp {

/// Evenly distributed over [low, high]; part of the rapidcheck case, so that a failure shrinks and replays.
inline double number(double low, double high) {
  return low +
         (high - low) * static_cast<double>(*rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 1'000'001))) / 1e6;
}

inline JointVector random_vector(int count, double magnitude) {
  JointVector vector(count);
  for (int i = 0; i < count; ++i) vector[i] = number(-magnitude, magnitude);
  return vector;
}

inline DesiredState random_state(int count) {
  return {random_vector(count, 2), random_vector(count, 1), random_vector(count, 6)};
}

}  // namespace mrroc::edp
