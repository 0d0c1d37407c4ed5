#pragma once

#include <cmath>

#include "mrroc/robot_parameters.hpp"

namespace mrroc {

/// How fast a shaft turns at most while its robot does not know where its joints are, rad/s: as fast as the axis looks
/// for its switch (`synchro_coarse`), or 20 where it has none. Any thread.
inline double search_speed(const AxisParameters& axis) noexcept {
  constexpr double kWithoutSwitch = 20;  // as slow as the axes of our robots that look for theirs
  return axis.synchro_coarse == 0 ? kWithoutSwitch : std::abs(axis.synchro_coarse);
}

}  // namespace mrroc
