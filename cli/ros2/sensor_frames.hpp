#pragma once

#include <functional>
#include <string>

#include "cli/ros2/robot_frames.hpp"

namespace mrroc::cli {

/// The frame of a sensor whose type has the keys `position` and `rotation`: in the flange frame of the robot that it is
/// mounted on, or in the world; as calibrated, where it has `mount_position`. Nothing: its place is unknown. `flange`:
/// the name of a robot's flange frame; `world`: of the world's. Any thread.
std::optional<messages::geometry_msgs::TransformStamped> sensor_frame(
    const config::SensorEntry& sensor, const std::function<std::string(const std::string& robot)>& flange,
    const std::string& world);

}  // namespace mrroc::cli
