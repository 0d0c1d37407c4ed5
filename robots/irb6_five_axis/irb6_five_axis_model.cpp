#include "robots/irb6_five_axis/irb6_five_axis_model.hpp"

#include "config/robot_files.hpp"
#include "robots/irb6/arm_model.hpp"
#include "robots/irb6_five_axis/five_axis_kinematics.hpp"

namespace mrroc {

RobotModels load_irb6_five_axis(const std::filesystem::path& file) {
  return irb6::load_arm<irb6::FiveAxisKinematics>(config::parameter_file("irb6_five_axis", file), 5);
}

}  // namespace mrroc
