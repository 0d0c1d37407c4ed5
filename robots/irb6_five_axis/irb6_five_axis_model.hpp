#pragma once

#include <filesystem>

#include "mrroc/robot_model.hpp"

namespace mrroc {

/// The models of the IRb-6 with five axes (robots/irb6/arm_model.hpp with the branch of five_axis_kinematics.hpp), read
/// from its parameter file: "nominal" first, then the file's others. Throws ConfigurationError. Configuration time
/// only. `file` empty: the
/// installed robots/irb6_five_axis/irb6_five_axis.toml.
RobotModels load_irb6_five_axis(const std::filesystem::path& file = {});

}  // namespace mrroc
