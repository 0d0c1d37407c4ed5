#pragma once

#include <string>

#include "config/robot_files.hpp"
#include "mrroc/robot_model.hpp"

namespace mrroc::edp {

/// Checks the files of a robot of type `type` before the EDP opens the drives: the parameter file names that type, its
/// numbers are consistent (`check_models`), and its URDF describes the same machine (`check_urdf`), if there is one.
/// Throws ConfigurationError. Configuration time only.
void check_robot(const RobotModels& models, const std::string& type, const config::RobotFiles& files);

}  // namespace mrroc::edp
