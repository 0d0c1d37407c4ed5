#pragma once

#include <array>

#include "mrroc/types.hpp"

namespace mrroc::polycrank {

inline constexpr int kAxes = 7;

/// `[geometry]` of polycrank.toml: the lengths of its Denavit-Hartenberg table. Lengths in m, signed.
struct Geometry {
  std::array<double, kAxes> offsets{};      ///< d of axes 1..7: along the axis, to the next crank
  std::array<double, 2> shoulder_cranks{};  ///< a of axes 1 and 2
  std::array<double, 2> elbow_cranks{};     ///< a of axes 4 and 5
  std::array<double, kAxes> gears{};        ///< rad of the motor per rad of the joint, the sign included
  Pose tool = Pose::Identity();             ///< tool frame in the flange frame
};

}  // namespace mrroc::polycrank
