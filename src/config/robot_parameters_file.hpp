#pragma once

#include "config/table.hpp"
#include "mrroc/robot_parameters.hpp"
#include "mrroc/types.hpp"

namespace mrroc::config {

/// Reads the general part of robots/TYPE/TYPE.toml: `type`, `home`, optionally `[postures]` (named joint positions for
/// the operator, `front = [...]`), `load_max` (kg) and `[tools]` (tool frames, `gripper = [x, y, z, roll, pitch, yaw]`,
/// m and rad), and `[[axes]]` with the keys of AxisParameters (same names;
/// `[regulators.SET.AXIS]` holds the values that differ in another regulator set: a, b0, b1, eps, output_max,
/// current_gain; only `encoder_increments` and `regulator_output_max` may be left out). Position and motor limits may
/// be infinite (`-inf`, `inf`, given explicitly): an axis that rotates endlessly. The `[geometry]` table
/// depends on the type: the robot's model reads it from the same Table and then calls `finish()`. Throws
/// ConfigurationError.
RobotParameters read_robot_parameters(const Table& file);

/// The default tool of an arm's `[geometry]`: `tool_translation`, m, and `tool_rotation`, rad, rotations about the
/// flange's fixed x, y and z axes in this order. Throws ConfigurationError.
Pose read_tool(const Table& geometry);

/// Path of robots/TYPE/NAME in the share folder that has the type.
std::filesystem::path robot_file(const std::string& type, const std::string& name);

}  // namespace mrroc::config
