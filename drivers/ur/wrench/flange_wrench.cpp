#include "drivers/ur/wrench/flange_wrench.hpp"

namespace mrroc::ur {
namespace {

Pose pose_of(const rtde::Vector6d& values) noexcept {
  Pose pose = Pose::Identity();
  pose.translation() << values[0], values[1], values[2];
  pose.linear() = rotation_of({values[3], values[4], values[5]});
  return pose;
}

}  // namespace

std::vector<std::string> wrench_fields() { return {"timestamp", "actual_TCP_force", "actual_TCP_pose", "tcp_offset"}; }

std::optional<WrenchPackage> read_wrench(const std::vector<rtde::Value>& values) noexcept {
  if (values.size() != 4) return {};
  const auto* const timestamp = std::get_if<double>(&values[0]);
  const auto* const force = std::get_if<rtde::Vector6d>(&values[1]);
  const auto* const tool = std::get_if<rtde::Vector6d>(&values[2]);
  const auto* const offset = std::get_if<rtde::Vector6d>(&values[3]);
  if (timestamp == nullptr || force == nullptr || tool == nullptr || offset == nullptr) return {};
  return WrenchPackage{*timestamp, Eigen::Map<const Wrench>(force->data()), pose_of(*tool), pose_of(*offset)};
}

Eigen::Matrix3d rotation_of(const Eigen::Vector3d& rotation_vector) noexcept {
  const double angle = rotation_vector.norm();
  if (angle == 0) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, rotation_vector / angle).toRotationMatrix();
}

Wrench load_on_sensor(const WrenchPackage& package, TorquePoint point, const Pose& mount) noexcept {
  const Eigen::Matrix3d to_flange = package.offset.linear() * package.tool.linear().transpose();
  const Eigen::Vector3d force = to_flange * package.force.head<3>();
  Eigen::Vector3d torque = to_flange * package.force.tail<3>();
  if (point == TorquePoint::tool) torque += package.offset.translation().cross(force);
  Wrench load;
  load << mount.linear().transpose() * force, mount.linear().transpose() * (torque - mount.translation().cross(force));
  return load;
}

}  // namespace mrroc::ur
