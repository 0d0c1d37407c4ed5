#include "robots/irb6/irb6_model.hpp"

#include "config/robot_parameters_file.hpp"
#include "robots/irb6/arm_model.hpp"
#include "robots/irb6/kinematics.hpp"

namespace mrroc {

RobotModels load_irb6(const std::filesystem::path& file) { return irb6::load_arm<irb6::Kinematics>(file, 6); }

RobotModels load_irb6() { return load_irb6(config::robot_file("irb6", "irb6.toml")); }

}  // namespace mrroc
