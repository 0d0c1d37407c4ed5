#pragma once

#include <cmath>

#include "mrroc/robot_parameters.hpp"

namespace mrroc {

/// Maximum speed of a shaft while its robot is not synchronised, rad/s: the speed at which the axis searches its switch
/// (`synchro_coarse`), or 20 for an axis without a switch. Any thread.
inline double search_speed(const AxisParameters& axis) noexcept {
  constexpr double kWithoutSwitch = 20;  // as slow as the other axes search their switches
  return axis.synchro_coarse == 0 ? kWithoutSwitch : std::abs(axis.synchro_coarse);
}

}  // namespace mrroc
