#include "robots/irb6/irb6_model.hpp"

#include <string>
#include <utility>

#include "config/robot_parameters_file.hpp"
#include "robots/irb6/geometry_file.hpp"

namespace mrroc {
namespace {

constexpr int kAxes = 6;

JointVector synchro_positions(const RobotParameters& parameters) {
  JointVector positions(kAxes);
  for (int i = 0; i < kAxes; ++i) positions[i] = parameters.axes.at(static_cast<std::size_t>(i)).motor_synchro;
  return positions;
}

}  // namespace

Irb6Model::Irb6Model(RobotParameters parameters, const irb6::Geometry& geometry)
    : parameters_(std::move(parameters)),
      transmission_(geometry, synchro_positions(parameters_)),
      kinematics_(geometry),
      tool_(geometry.tool) {}

ErrorCode Irb6Model::motors_to_joints(const JointVector& motors, JointVector& joints) const noexcept {
  return transmission_.motors_to_joints(motors, joints);
}

ErrorCode Irb6Model::joints_to_motors(const JointVector& joints, JointVector& motors) const noexcept {
  return transmission_.joints_to_motors(joints, motors);
}

JointMatrix Irb6Model::transmission(const JointVector& joints) const noexcept { return transmission_.matrix(joints); }

RobotModels load_irb6(const std::filesystem::path& file) {
  const auto table = config::Table::load(file);
  auto parameters = config::read_robot_parameters(table);
  if (parameters.axes.size() != kAxes) {
    table.fail("axes", std::to_string(parameters.axes.size()) + " axes", std::to_string(kAxes) + " axes");
  }
  const auto geometry = irb6::read_geometry(table.table("geometry"));
  table.finish();
  return {std::make_shared<Irb6Model>(std::move(parameters), geometry)};
}

RobotModels load_irb6() { return load_irb6(config::robot_file("irb6", "irb6.toml")); }

}  // namespace mrroc
