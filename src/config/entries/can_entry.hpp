#pragma once

#include "config/deployment.hpp"
#include "config/table.hpp"

namespace mrroc::config {

/// Reads [robots.NAME.can] of a robot whose type, host and hardware are known, with its tables of drives and I/O nodes,
/// and decides `synchronised`. Throws ConfigurationError, also for an `emergency_stop` that is not an input of them.
void read_can(const Table& robot_table, const Deployment& deployment, RobotEntry& robot);

}  // namespace mrroc::config
