#pragma once

#include "config/deployment.hpp"
#include "config/table.hpp"

namespace mrroc::config {

/// Checks `force_sensor` of every robot of `deployment`, which was read from `root`: it names a sensor whose type gives
/// a wrench and that the robot carries. On the robot's own host finds the library of that type. Throws
/// ConfigurationError, also for a library that is not there.
void settle_force_sensors(const Table& root, Deployment& deployment);

}  // namespace mrroc::config
