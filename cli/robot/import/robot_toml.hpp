#pragma once

#include <string>
#include <vector>

#include "cli/robot/import/axis_drives.hpp"
#include "cli/robot/import/axis_limits.hpp"

namespace mrroc::cli {

/// The parameter file of an arm of the stock type, with the source of every number in a comment. `urdf`: the URDF's
/// path, for the first line. Any thread.
std::string robot_toml(const std::string& type, const std::string& urdf, const UrdfArm& arm,
                       const std::vector<AxisLimits>& axes, DriveKind kind, const std::vector<AxisDrive>& drives,
                       const JointVector& home);

}  // namespace mrroc::cli
