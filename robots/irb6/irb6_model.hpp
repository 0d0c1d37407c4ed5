#pragma once

#include <filesystem>

#include "mrroc/robot_model.hpp"

namespace mrroc {

/// The models of an arm built as the IRb-6 with six axes (arm_model.hpp with the branches of kinematics.hpp), read from
/// its parameter file: "nominal" first, then the file's others. Throws ConfigurationError. Configuration time only.
/// `file` empty: the installed robots/irb6/irb6.toml.
RobotModels load_irb6(const std::filesystem::path& file = {});

}  // namespace mrroc
