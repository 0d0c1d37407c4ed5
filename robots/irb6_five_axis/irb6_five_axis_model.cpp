#include "robots/irb6_five_axis/irb6_five_axis_model.hpp"

#include "config/robot_parameters_file.hpp"
#include "robots/irb6/arm_model.hpp"
#include "robots/irb6_five_axis/five_axis_kinematics.hpp"

namespace mrroc {

RobotModels load_irb6_five_axis(const std::filesystem::path& file) {
  return irb6::load_arm<irb6::FiveAxisKinematics>(file, 5);
}

RobotModels load_irb6_five_axis() {
  return load_irb6_five_axis(config::robot_file("irb6_five_axis", "irb6_five_axis.toml"));
}

}  // namespace mrroc
