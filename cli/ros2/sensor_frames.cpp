#include "cli/ros2/sensor_frames.hpp"

#include "geometry/rigid_motion.hpp"

namespace mrroc::cli {

namespace {

/// The three numbers of a key; nothing: it is not declared, or has none.
std::optional<Eigen::Vector3d> vector_of(const config::SensorEntry& sensor, const std::string& key) {
  const auto found = sensor.numbers.find(key);
  if (found == sensor.numbers.end() || found->second.size() != 3) return std::nullopt;
  return Eigen::Vector3d(found->second.data());
}

}  // namespace

std::optional<messages::geometry_msgs::TransformStamped> sensor_frame(
    const config::SensorEntry& sensor, const std::function<std::string(const std::string& robot)>& flange,
    const std::string& world) {
  const bool calibrated = vector_of(sensor, "mount_position").has_value();
  const auto position = vector_of(sensor, calibrated ? "mount_position" : "position");
  if (!position) return std::nullopt;
  const auto rotation = vector_of(sensor, calibrated ? "mount_rotation" : "rotation");
  const Pose pose = pose_from_rpy(*position, rotation.value_or(Eigen::Vector3d::Zero()));
  return transform_of(sensor.robot.empty() ? world : flange(sensor.robot), sensor.name, pose);
}

}  // namespace mrroc::cli
