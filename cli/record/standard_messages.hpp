#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "config/deployment.hpp"
#include "messages/geometry_msgs/wrench_stamped.hpp"
#include "messages/sensor_msgs/joint_state.hpp"

namespace mrroc::cli::record {

/// The joints of a robot as its axes are named, which are the names of the URDF. Throws config::ConfigurationError: its
/// parameter file is invalid.
std::vector<std::string> joint_names(const config::RobotEntry& robot);

/// Topics of these messages.
std::string joint_topic(const std::string& robot);
std::string wrench_topic(const std::string& name);
/// The frame of the wrench on a robot's tool.
std::string tool_frame(const std::string& robot);

/// `values`: fx, fy, fz (N), tx, ty, tz (N m).
messages::geometry_msgs::WrenchStamped to_wrench(const std::string& frame,
                                                 const messages::builtin_interfaces::Time& stamp,
                                                 std::span<const double, 6> values);

}  // namespace mrroc::cli::record
