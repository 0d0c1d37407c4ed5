#include "robots/conveyor/conveyor_model.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "config/robot_files.hpp"
#include "config/robot_parameters_file.hpp"

namespace mrroc {
namespace {

constexpr double kOffLine = 1e-6;  // m, and rad

double read_gear(const config::Table& geometry) {
  const double gear = geometry.number("gear");
  if (gear == 0) geometry.fail("gear", "0 is not a gear ratio", "rad of the motor per m, its sign included");
  geometry.finish();
  return gear;
}

}  // namespace

ConveyorModel::ConveyorModel(RobotParameters parameters, double gear)
    : parameters_(std::move(parameters)), gear_(gear), synchro_(parameters_.axes.front().motor_synchro) {}

ErrorCode ConveyorModel::motors_to_joints(const JointVector& motors, JointVector& joints) const noexcept {
  const double travel = (motors[0] - synchro_) / gear_;
  if (!std::isfinite(travel)) return ErrorCode::motor_limit;
  joints = JointVector::Constant(1, travel);
  return ErrorCode::none;
}

ErrorCode ConveyorModel::joints_to_motors(const JointVector& joints, JointVector& motors) const noexcept {
  const double motor = gear_ * joints[0] + synchro_;
  if (!std::isfinite(motor)) return ErrorCode::joint_limit;
  motors = JointVector::Constant(1, motor);
  return ErrorCode::none;
}

JointMatrix ConveyorModel::transmission(const JointVector& /*joints*/) const noexcept {
  return JointMatrix::Constant(1, 1, gear_);
}

Pose ConveyorModel::flange(const JointVector& joints) const noexcept {
  Pose pose = Pose::Identity();
  pose.translation().x() = joints[0];
  return pose;
}

ErrorCode ConveyorModel::inverse(const Pose& flange, const JointVector& /*near*/, JointVector& joints) const noexcept {
  const Eigen::Vector3d p = flange.translation();
  // written so that a value that is not a number fails
  const bool on_line = std::isfinite(p.x()) && p.tail<2>().norm() <= kOffLine &&
                       (flange.linear() - Eigen::Matrix3d::Identity()).norm() <= kOffLine;
  if (!on_line) return ErrorCode::out_of_workspace;
  joints = JointVector::Constant(1, p.x());
  return ErrorCode::none;
}

void ConveyorModel::branches(const Pose& flange, const JointVector& near, BranchReceiver& receiver) const noexcept {
  JointVector joints = JointVector::Constant(1, flange.translation().x());
  const bool exact = inverse(flange, near, joints) == ErrorCode::none;
  receiver.add(joints, exact);
}

Jacobian ConveyorModel::jacobian(const JointVector& /*joints*/, const Eigen::Vector3d& /*offset*/) const noexcept {
  Jacobian jacobian = Jacobian::Zero(6, 1);
  jacobian(0, 0) = 1;
  return jacobian;
}

RobotModels load_conveyor(const std::filesystem::path& file) {
  const auto table = config::Table::load(config::parameter_file("conveyor", file));
  auto parameters = config::read_robot_parameters(table);
  if (parameters.axes.size() != 1) {
    table.fail("axes", std::to_string(parameters.axes.size()) + " axes", "one axis, the belt");
  }
  const double gear = read_gear(table.table("geometry"));
  table.finish();
  return {std::make_shared<ConveyorModel>(std::move(parameters), gear)};
}

}  // namespace mrroc
