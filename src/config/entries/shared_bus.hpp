#pragma once

#include <vector>

#include "config/deployment.hpp"
#include "config/drives/drive_table.hpp"
#include "config/drives/io_table.hpp"
#include "config/table.hpp"

namespace mrroc::config {

/// The nodes of one robot on a bus.
struct BusNodes {
  const RobotEntry& robot;  ///< must outlive it
  DriveTable drives;
  IoTable io;
};

/// The earlier robots of the deployment on the bus of `robot`, with their tables. Throws ConfigurationError.
std::vector<BusNodes> others_on_bus(const Deployment& deployment, const RobotEntry& robot);

/// Checks the last of `all` against the other robots on its bus: each master has its own node number and SYNC, and no
/// two nodes have one number. `can`: its [robots.NAME.can]. Throws ConfigurationError.
void check_shared_bus(const Table& can, const std::vector<BusNodes>& all);

}  // namespace mrroc::config
