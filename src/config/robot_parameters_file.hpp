#pragma once

#include "config/table.hpp"
#include "mrroc/robot_parameters.hpp"

namespace mrroc::config {

/// Reads the general part of robots/<type>/<type>.toml: `type`, `home`, and `[[axes]]` with the keys of AxisParameters
/// (same names). The `[geometry]` table is the robot's own: its model reads it from the same Table. Throws
/// ConfigurationError.
RobotParameters read_robot_parameters(const Table& file);

/// Path of robots/<type>/<name> in the share folder.
std::filesystem::path robot_file(const std::string& type, const std::string& name);

}  // namespace mrroc::config
