#pragma once

#include "config/deployment.hpp"
#include "config/table.hpp"

namespace mrroc::config {

/// Checks `force_sensor` of every robot of `deployment`, which was read from `root`: it names a sensor of type
/// force_torque that the robot carries and that no other robot's EDP reads. Throws ConfigurationError.
void check_force_sensors(const Table& root, const Deployment& deployment);

}  // namespace mrroc::config
