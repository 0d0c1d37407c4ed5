#pragma once

#include <string>
#include <string_view>

namespace mrroc::ros2 {

// How ROS 2 names things on DDS (design.ros2.org, "Topic and Service name mapping to DDS"). Any thread.

/// "rt/arm/joint_states" of "/arm/joint_states".
std::string dds_topic(std::string_view topic);
/// "rq/mrroc/startRequest" and "rr/mrroc/startReply" of "/mrroc/start".
std::string dds_request_topic(std::string_view service);
std::string dds_reply_topic(std::string_view service);
/// "/arm/move/_action/status" of the action "/arm/move" and "status".
std::string action_name(std::string_view action, std::string_view part);
/// "sensor_msgs::msg::dds_::JointState_" of "sensor_msgs/msg/JointState".
std::string dds_type(std::string_view type);

/// A name of a node, or a part of a topic's, made of any text: letters, digits and `_`, the first no digit.
std::string ros_name(std::string_view text);
/// `name` in this namespace: "/lab/arm" of "/lab" and "arm".
std::string in_namespace(std::string_view space, std::string_view name);

}  // namespace mrroc::ros2
