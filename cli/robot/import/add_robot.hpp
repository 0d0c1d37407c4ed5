#pragma once

#include <string>

#include "cli/robot/robot_verbs.hpp"

namespace mrroc::cli {

/// Makes a robot type of a URDF: a folder with parameters, URDF, meshes, MJCF, and a deployment that runs the stock
/// demo. It is complete or it does not exist. Returns lines for people: what was written, the structure of the inverse,
/// the reach, what was guessed, the next command. Throws config::ConfigurationError for what is wrong in the files or
/// arguments, SystemError when a file cannot be written. Configuration time only.
std::string add_robot(const AddRequest& request);

}  // namespace mrroc::cli
