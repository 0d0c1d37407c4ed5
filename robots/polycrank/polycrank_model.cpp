#include "robots/polycrank/polycrank_model.hpp"

#include <string>
#include <utility>

#include "config/robot_files.hpp"
#include "config/robot_parameters_file.hpp"
#include "robots/polycrank/geometry_file.hpp"

namespace mrroc {

using polycrank::kAxes;

PolycrankModel::PolycrankModel(RobotParameters parameters, const polycrank::Geometry& geometry)
    : parameters_(std::move(parameters)), kinematics_(geometry), tool_(geometry.tool), gears_(kAxes), synchro_(kAxes) {
  for (std::size_t i = 0; i < kAxes; ++i) {
    gears_[static_cast<Eigen::Index>(i)] = geometry.gears[i];
    synchro_[static_cast<Eigen::Index>(i)] = parameters_.axes.at(i).motor_synchro;
  }
}

ErrorCode PolycrankModel::motors_to_joints(const JointVector& motors, JointVector& joints) const noexcept {
  const JointVector result = (motors - synchro_).cwiseQuotient(gears_);
  if (!result.allFinite()) return ErrorCode::motor_limit;
  joints = result;
  return ErrorCode::none;
}

ErrorCode PolycrankModel::joints_to_motors(const JointVector& joints, JointVector& motors) const noexcept {
  const JointVector result = joints.cwiseProduct(gears_) + synchro_;
  if (!result.allFinite()) return ErrorCode::joint_limit;
  motors = result;
  return ErrorCode::none;
}

JointMatrix PolycrankModel::transmission(const JointVector&) const noexcept { return gears_.asDiagonal(); }

Pose PolycrankModel::flange(const JointVector& joints) const noexcept { return kinematics_.flange(joints); }

ErrorCode PolycrankModel::inverse(const Pose& flange, const JointVector& near, JointVector& joints) const noexcept {
  return kinematics_.inverse(flange, near, joints);
}

Jacobian PolycrankModel::jacobian(const JointVector& joints, const Eigen::Vector3d& offset) const noexcept {
  return kinematics_.jacobian(joints, offset);
}

RobotModels load_polycrank(const std::filesystem::path& file) {
  const auto table = config::Table::load(config::parameter_file("polycrank", file));
  auto parameters = config::read_robot_parameters(table);
  if (parameters.axes.size() != kAxes) {
    table.fail("axes", std::to_string(parameters.axes.size()) + " axes", std::to_string(kAxes) + " axes");
  }
  const auto geometry = polycrank::read_geometry(table.table("geometry"));
  table.finish();
  return {std::make_shared<PolycrankModel>(std::move(parameters), geometry)};
}

}  // namespace mrroc
