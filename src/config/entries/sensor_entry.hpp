#pragma once

#include <string>

#include "config/deployment.hpp"
#include "config/table.hpp"

namespace mrroc::config {

/// Reads [sensors.NAME]; `deployment` holds the sections read before it: the servo period, [sim] and all robots. Throws
/// ConfigurationError.
SensorEntry read_sensor(const Table& table, const std::string& name, const Deployment& deployment);

}  // namespace mrroc::config
