#include "robots/serial_parallel/serial_parallel_model.hpp"

#include <string>
#include <utility>

#include "config/robot_files.hpp"
#include "config/robot_parameters_file.hpp"
#include "robots/serial_parallel/geometry_file.hpp"

namespace mrroc {
namespace {

constexpr int kAxes = 6;

JointVector synchro_motors(const RobotParameters& parameters) {
  JointVector positions(kAxes);
  for (int i = 0; i < kAxes; ++i) positions[i] = parameters.axes.at(static_cast<std::size_t>(i)).motor_synchro;
  return positions;
}

}  // namespace

SerialParallelModel::SerialParallelModel(RobotParameters parameters, const serial_parallel::Geometry& geometry)
    : parameters_(std::move(parameters)),
      kinematics_(geometry),
      gears_(geometry.gears),
      synchro_motors_(synchro_motors(parameters_)),
      synchro_joints_(geometry.synchro),
      tool_(geometry.tool) {}

ErrorCode SerialParallelModel::motors_to_joints(const JointVector& motors, JointVector& joints) const noexcept {
  const JointVector found = synchro_joints_ + (motors - synchro_motors_).cwiseQuotient(gears_);
  if (!found.allFinite()) return ErrorCode::motor_limit;
  joints = found;
  return ErrorCode::none;
}

ErrorCode SerialParallelModel::joints_to_motors(const JointVector& joints, JointVector& motors) const noexcept {
  const JointVector found = synchro_motors_ + (joints - synchro_joints_).cwiseProduct(gears_);
  if (!found.allFinite() || !kinematics_.reaches(joints, kOvershoot)) return ErrorCode::joint_limit;
  motors = found;
  return ErrorCode::none;
}

ClosedLoops SerialParallelModel::closed_loops(const JointVector& joints) const {
  const serial_parallel::Placement placement = kinematics_.placement(joints);
  const serial_parallel::PassiveAngles angles = kinematics_.passive_angles(placement);
  return {.joints = {{"swing_a", placement.swing},
                     {"lean_a", angles.lean_a},
                     {"tilt_a", placement.tilt - angles.lean_a},
                     {"swing_c", placement.swing},
                     {"lean_c", angles.lean_c},
                     {"pitch_b", angles.pitch_b},
                     {"lean_b", angles.lean_b}},
          .joined = {{"head_b", "joint_b"}, {"head_c", "joint_c"}}};
}

RobotModels load_serial_parallel(const std::filesystem::path& file) {
  const auto table = config::Table::load(config::parameter_file("serial_parallel", file));
  auto parameters = config::read_robot_parameters(table);
  if (parameters.axes.size() != kAxes) {
    table.fail("axes", std::to_string(parameters.axes.size()) + " axes", std::to_string(kAxes) + " axes");
  }
  const auto geometry = serial_parallel::read_geometry(table.table("geometry"));
  if (!serial_parallel::Kinematics(geometry).reaches(parameters.home, 0)) {
    table.fail("home", "the legs do not close within the passive limits", "joints that the tripod can take");
  }
  table.finish();
  return {std::make_shared<SerialParallelModel>(std::move(parameters), geometry)};
}

}  // namespace mrroc
