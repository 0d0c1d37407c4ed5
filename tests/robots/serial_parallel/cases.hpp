#pragma once

#include <random>

#include "fixture.hpp"
#include "robots/common/any_number.hpp"

namespace mrroc {

/// Within the limits of joints and passive joints.
inline JointVector any_posture() {
  std::mt19937_64 random(static_cast<std::uint64_t>(any_step()));
  return random_posture(random);
}

/// An upright platform, within the limits or not.
inline serial_parallel::Placement any_placement() {
  return {.swing = any_between(-1.2, 1.2), .tilt = any_between(-1.2, 1.2), .height = any_between(0.1, 0.5)};
}

}  // namespace mrroc
