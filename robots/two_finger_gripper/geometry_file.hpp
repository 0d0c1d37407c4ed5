#pragma once

#include "config/table.hpp"
#include "mrroc/robot_parameters.hpp"
#include "robots/two_finger_gripper/transmission.hpp"

namespace mrroc::two_finger_gripper {

/// Reads `[geometry]` of two_finger_gripper.toml, given as its table. Throws ConfigurationError, also for a parabola
/// whose dead centre is within the motor's limits: there the fingers would reverse.
Geometry read_geometry(const config::Table& table, const AxisParameters& axis);

}  // namespace mrroc::two_finger_gripper
