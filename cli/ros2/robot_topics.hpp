#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "cli/ros2/robot_frames.hpp"
#include "links/ros2/publisher.hpp"
#include "messages/geometry_msgs/wrench_stamped.hpp"
#include "messages/sensor_msgs/joint_state.hpp"
#include "messages/std_msgs/string.hpp"

namespace mrroc::cli {

/// The topics of one robot: `joint_states`, `robot_description` and, where its EDP has a force sensor, `wrench` on the
/// tool. One thread.
class RobotTopics {
 public:
  /// `name_space`: of its topics. The node outlives it.
  RobotTopics(ros2::Node& node, const config::RobotEntry& robot, const std::string& name_space, RobotFrames frames);

  const RobotFrames& frames() const noexcept { return frames_; }
  /// Publishes a state of the robot, a run's event "robot", and appends its frames.
  void publish(const nlohmann::ordered_json& event, const messages::builtin_interfaces::Time& stamp,
               RobotFrames::Transforms& transforms);

 private:
  RobotFrames frames_;
  ros2::Publisher<messages::sensor_msgs::JointState> joint_states_;
  std::optional<ros2::Publisher<messages::std_msgs::String>> description_;
  std::optional<ros2::Publisher<messages::geometry_msgs::WrenchStamped>> wrench_;
};

}  // namespace mrroc::cli
