#include "cli/ros2/robot_topics.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "cli/record/standard_messages.hpp"
#include "cli/ros2/event_numbers.hpp"
#include "links/ros2/ros_names.hpp"

namespace mrroc::cli {

RobotTopics::RobotTopics(ros2::Node& node, const config::RobotEntry& robot, const std::string& name_space,
                         RobotFrames frames)
    : frames_(std::move(frames)), joint_states_(node, ros2::in_namespace(name_space, "joint_states")) {
  if (!frames_.description().empty()) {
    description_.emplace(node, ros2::in_namespace(name_space, "robot_description"), ros2::Durability::last);
    messages::std_msgs::String text;
    text.data = frames_.description();
    description_->publish(text);
  }
  if (!robot.force_sensor.empty()) wrench_.emplace(node, ros2::in_namespace(name_space, "wrench"));
}

void RobotTopics::publish(const nlohmann::ordered_json& event, const messages::builtin_interfaces::Time& stamp,
                          RobotFrames::Transforms& transforms) {
  messages::sensor_msgs::JointState state;
  state.header.stamp = stamp;
  state.name = frames_.joints();
  state.position = numbers_of(event, "joints");
  state.velocity = numbers_of(event, "velocity");
  if (state.position.size() != state.name.size() || state.velocity.size() != state.name.size()) return;
  // before the absolute positions are known the joints are not, and a viewer would show a wrong robot
  if (event.value("synchronised", false)) {
    joint_states_.publish(state);
    frames_.append(stamp, state.position, pose_of(event, "pose"), pose_of(event, "tool"), transforms);
  }
  const std::vector<double> wrench = numbers_of(event, "wrench");
  if (wrench_ && wrench.size() == 6)
    wrench_->publish(record::to_wrench(frames_.tool(), stamp, std::span<const double, 6>(wrench.data(), 6)));
}

}  // namespace mrroc::cli
