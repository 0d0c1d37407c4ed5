#pragma once

#include <filesystem>

#include "mrroc/robot_model.hpp"

namespace mrroc {

/// The models of an arm, read from the parameter file of its type: "nominal" from its table `[chain]`, then one of each
/// table `[models.NAME]`, for example a calibrated one. `[chain]`:
///
///     base = "base_link"                     # links of the URDF, for people and checks
///     tip = "tool0"
///     flange = [x, y, z, roll, pitch, yaw]   # the tip in the last joint's frame, m and rad
///     [chain.joints]
///     AXIS = { frame = [x, y, z, roll, pitch, yaw], axis = [0, 0, 1] }
///
/// with a joint for each axis, in their order: its frame at position 0 in that of the joint before (of the first one:
/// in the base's), its axis there (any length), `kind = "slides"` where it slides, and `gear`, the turns of the motor
/// for a turn of the joint, rad/rad or rad/m (default 1). A model has `flange` and `joints`, too, and what it leaves
/// out is the chain's. Throws ConfigurationError. Configuration time only.
RobotModels load_arm(const std::filesystem::path& file);

}  // namespace mrroc
