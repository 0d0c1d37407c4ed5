#pragma once

#include "mrroc/robot_model.hpp"

namespace mrroc {

/// Models of the installed robots/fast_conveyor/fast_conveyor.toml: a robot built as the conveyor, so it is the
/// conveyor's model (robots/conveyor/conveyor_model.hpp) with other numbers. Throws ConfigurationError. Configuration
/// time only.
RobotModels load_fast_conveyor();

}  // namespace mrroc
