#pragma once

#include <filesystem>

#include "mrroc/robot_model.hpp"

namespace mrroc {

/// Reads a parameter file of the IRb-60: it is built as the IRb-6 with six axes, so its models are those of the IRb-6
/// (robots/irb6/irb6_model.hpp) with other numbers. Throws ConfigurationError. Configuration time only. `file` empty:
/// the installed robots/irb60/irb60.toml.
RobotModels load_irb60(const std::filesystem::path& file = {});

}  // namespace mrroc
