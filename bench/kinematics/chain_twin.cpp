#include "bench/kinematics/chain_twin.hpp"

#include "cli/robot/urdf_arm.hpp"
#include "config/robot_parameters_file.hpp"
#include "kinematics/chain_model.hpp"

namespace mrroc::bench {

RobotModels chain_twin(const RobotParameters& parameters) {
  const auto urdf = edp::Urdf::load(config::robot_file(parameters.type, parameters.type + ".urdf"));
  const cli::UrdfArm arm = cli::arm_of(urdf, "", "tool_frame");
  RobotParameters twin = parameters;
  for (AxisParameters& axis : twin.axes) {
    axis.motor_min = -std::numeric_limits<double>::infinity();
    axis.motor_max = std::numeric_limits<double>::infinity();
  }
  return {std::make_shared<kinematics::ChainModel>("chain", twin, arm.chain, JointVector::Ones(arm.chain.size()))};
}

}  // namespace mrroc::bench
