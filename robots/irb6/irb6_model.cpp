#include "robots/irb6/irb6_model.hpp"

#include "config/robot_files.hpp"
#include "robots/irb6/arm_model.hpp"
#include "robots/irb6/kinematics.hpp"

namespace mrroc {

RobotModels load_irb6(const std::filesystem::path& file) {
  return irb6::load_arm<irb6::Kinematics>(config::parameter_file("irb6", file), 6);
}

}  // namespace mrroc
