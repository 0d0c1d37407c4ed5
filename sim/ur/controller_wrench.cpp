// The tool of a UR controller and the wrench on it.
#include "drivers/ur/wrench/flange_wrench.hpp"
#include "sim/ur/virtual_controller.hpp"

namespace mrroc::sim::ur {
namespace {

constexpr double kGravity = 9.81;  // m/s^2

Six six_of(const Eigen::Vector3d& first, const Eigen::Vector3d& second) {
  return {first[0], first[1], first[2], second[0], second[1], second[2]};
}

Six six_of(const Pose& pose) {
  const Eigen::AngleAxisd rotation(pose.linear());
  return six_of(pose.translation(), rotation.angle() * rotation.axis());
}

}  // namespace

Six VirtualController::tool_pose() const { return six_of(plant_->flange().pose * settings_.tool); }

Six VirtualController::tool_offset() const { return six_of(settings_.tool); }

Six VirtualController::tool_force() const {
  const Flange flange = plant_->flange();
  const Eigen::Matrix3d rotation = flange.pose.linear();
  const Eigen::Vector3d weight = rotation.transpose() * Eigen::Vector3d(0, 0, -kGravity * settings_.payload);
  const Eigen::Vector3d force = flange.load.head<3>() - weight;
  Eigen::Vector3d torque = flange.load.tail<3>() - settings_.payload_centre.cross(weight);
  if (!mrroc::ur::rtde::is_e_series(options_.version)) torque -= settings_.tool.translation().cross(force);
  return six_of(rotation * force, rotation * torque);
}

Six VirtualController::flange_load() const {
  const Wrench load = plant_->flange().load;
  return six_of(load.head<3>(), load.tail<3>());
}

}  // namespace mrroc::sim::ur
