#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "links/ros2/publisher.hpp"
#include "messages/control_msgs/follow_joint_trajectory_feedback_message.hpp"
#include "messages/control_msgs_kilted/follow_joint_trajectory_feedback_message.hpp"

namespace mrroc::cli {

/// The state of a robot on its trajectory. Arrays have one value of each axis, rad or m.
struct TrajectoryProgress {
  messages::builtin_interfaces::Time stamp;
  double time = 0;                      ///< on the trajectory, s
  std::int32_t index = 0;               ///< of the point that the robot approaches
  std::vector<double> desired, actual;  ///< positions
  std::vector<double> velocity;         ///< measured, per second
};

/// The topic `feedback` of FollowJointTrajectory as the distribution has it. One thread.
class TrajectoryFeedback {
 public:
  /// `action`: its absolute name; `joints`: names of the robot's axes. The node outlives it.
  TrajectoryFeedback(ros2::Node& node, ros2::Distro distro, const std::string& action, std::vector<std::string> joints);

  void publish(const messages::unique_identifier_msgs::UUID& goal, const TrajectoryProgress& progress);

 private:
  std::vector<std::string> joints_;
  std::optional<ros2::Publisher<messages::control_msgs::FollowJointTrajectoryFeedbackMessage>> until_jazzy_;
  std::optional<ros2::Publisher<messages::control_msgs_kilted::FollowJointTrajectoryFeedbackMessage>> from_kilted_;
};

}  // namespace mrroc::cli
