#include "robots/two_finger_gripper/two_finger_gripper_model.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "config/robot_files.hpp"
#include "config/robot_parameters_file.hpp"
#include "robots/two_finger_gripper/geometry_file.hpp"

namespace mrroc {
namespace {

constexpr double kOffLine = 1e-6;  // m, and rad

}  // namespace

TwoFingerGripperModel::TwoFingerGripperModel(RobotParameters parameters, const two_finger_gripper::Geometry& geometry)
    : parameters_(std::move(parameters)),
      transmission_(geometry, parameters_.axes.front().motor_synchro),
      reach_(geometry.reach) {}

ErrorCode TwoFingerGripperModel::motors_to_joints(const JointVector& motors, JointVector& joints) const noexcept {
  const auto opening = transmission_.opening(motors[0]);
  if (!opening) return ErrorCode::motor_limit;
  joints = JointVector::Constant(1, *opening);
  return ErrorCode::none;
}

ErrorCode TwoFingerGripperModel::joints_to_motors(const JointVector& joints, JointVector& motors) const noexcept {
  const auto motor = transmission_.motor(joints[0]);
  if (!motor) return ErrorCode::joint_limit;
  motors = JointVector::Constant(1, *motor);
  return ErrorCode::none;
}

JointMatrix TwoFingerGripperModel::transmission(const JointVector& joints) const noexcept {
  return JointMatrix::Constant(1, 1, transmission_.ratio(joints[0]));
}

Pose TwoFingerGripperModel::flange(const JointVector& joints) const noexcept {
  Pose pose = Pose::Identity();
  pose.translation() << joints[0] / 2, 0, reach_;
  return pose;
}

ErrorCode TwoFingerGripperModel::inverse(const Pose& flange, const JointVector& /*near*/,
                                         JointVector& joints) const noexcept {
  const Eigen::Vector3d p = flange.translation();
  // written so that a value that is not a number fails
  const bool on_line = std::isfinite(p.x()) && std::hypot(p.y(), p.z() - reach_) <= kOffLine &&
                       (flange.linear() - Eigen::Matrix3d::Identity()).norm() <= kOffLine;
  if (!on_line) return ErrorCode::out_of_workspace;
  joints = JointVector::Constant(1, 2 * p.x());
  return ErrorCode::none;
}

void TwoFingerGripperModel::branches(const Pose& flange, const JointVector& near,
                                     BranchReceiver& receiver) const noexcept {
  JointVector joints = JointVector::Constant(1, 2 * flange.translation().x());
  const bool exact = inverse(flange, near, joints) == ErrorCode::none;
  receiver.add(joints, exact);
}

Jacobian TwoFingerGripperModel::jacobian(const JointVector& /*joints*/,
                                         const Eigen::Vector3d& /*offset*/) const noexcept {
  Jacobian jacobian = Jacobian::Zero(6, 1);
  jacobian(0, 0) = 0.5;
  return jacobian;
}

RobotModels load_two_finger_gripper(const std::filesystem::path& file) {
  const auto table = config::Table::load(config::parameter_file("two_finger_gripper", file));
  auto parameters = config::read_robot_parameters(table);
  if (parameters.axes.size() != 1) {
    table.fail("axes", std::to_string(parameters.axes.size()) + " axes", "one axis, the opening");
  }
  const auto geometry = two_finger_gripper::read_geometry(table.table("geometry"), parameters.axes.front());
  table.finish();
  return {std::make_shared<TwoFingerGripperModel>(std::move(parameters), geometry)};
}

}  // namespace mrroc
