#pragma once

#include <filesystem>
#include <string>

#include "mrroc/robot_model.hpp"

namespace mrroc::calibration {

/// The models of a robot of type `type`, read from its parameter file: of a type of robots/, or of an arm that its file
/// describes as a chain of joints. Throws ConfigurationError. Configuration time only.
RobotModels load_models(const std::string& type, const std::filesystem::path& parameters);

}  // namespace mrroc::calibration
