#pragma once

#include <string>

#include "config/deployment.hpp"
#include "config/table.hpp"

namespace mrroc::config {

/// Reads [robots.NAME]; `deployment` holds the sections read before it, of which [sim] matters. It does not check
/// `mount`: `check_mounts` does, when all robots are known. Throws ConfigurationError.
RobotEntry read_robot(const Table& table, const std::string& name, const Deployment& deployment);

}  // namespace mrroc::config
