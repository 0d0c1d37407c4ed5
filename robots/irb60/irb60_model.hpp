#pragma once

#include "mrroc/robot_model.hpp"

namespace mrroc {

/// Models of the installed robots/irb60/irb60.toml: a robot built as the IRb-6 with six axes, so it is the IRb-6's
/// model (robots/irb6/irb6_model.hpp) with other numbers. Throws ConfigurationError. Configuration time only.
RobotModels load_irb60();

}  // namespace mrroc
