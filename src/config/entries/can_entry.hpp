#pragma once

#include "config/deployment.hpp"
#include "config/table.hpp"

namespace mrroc::config {

/// Reads [robots.NAME.can] of a robot whose type, host and hardware are known, with its table of drives, and decides
/// `synchronised`. Throws ConfigurationError.
void read_can(const Table& robot_table, const Deployment& deployment, RobotEntry& robot);

}  // namespace mrroc::config
