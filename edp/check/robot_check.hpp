#pragma once

#include <string>

#include "config/robot_files.hpp"
#include "mrroc/robot_model.hpp"

namespace mrroc::edp {

/// What an EDP asks of its robot of type `type` before it opens the drives: the parameter file names that type, its
/// numbers go together (`check_models`), and its URDF is the same machine (`check_urdf`). A robot without a URDF has
/// none to disagree with. Throws ConfigurationError. Configuration time only.
void check_robot(const RobotModels& models, const std::string& type, const config::RobotFiles& files);

}  // namespace mrroc::edp
