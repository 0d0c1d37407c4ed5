#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "cli/operator/socket/side_program.hpp"
#include "cli/ros2/cameras/camera_topics.hpp"
#include "cli/ros2/cameras/hardware_camera_topics.hpp"
#include "cli/ros2/diagnostics.hpp"
#include "cli/ros2/follow_action.hpp"
#include "cli/ros2/operator_requests.hpp"
#include "cli/ros2/robot_topics.hpp"
#include "cli/ros2/stamps.hpp"
#include "cli/ros2/trigger_services.hpp"
#include "config/deployment.hpp"
#include "links/ros2/publisher.hpp"
#include "messages/rcl_interfaces/log.hpp"
#include "messages/rosgraph_msgs/clock.hpp"
#include "messages/tf2_msgs/tf_message.hpp"

namespace mrroc::cli {

/// A run as a node of ROS 2. It knows the run by its socket alone, as any watcher: states at most 50 times a second,
/// newest only. One thread.
class Bridge {
 public:
  /// `entry`: how; its domain is given. Connects nothing yet; throws as ros2::Node, RobotFrames. `run` outlives it.
  Bridge(const config::Ros2Entry& entry, WatchedRun& run);

  /// The node's full name.
  const std::string& node() const noexcept { return node_name_; }
  /// Serves until the run ends or `stop`, a descriptor, becomes readable.
  void serve(int stop);

 private:
  using Json = nlohmann::ordered_json;

  void add_robots(const config::Deployment& deployment);
  /// The services and actions that operate the run.
  void add_commands(ros2::Distro distro, const config::Deployment& deployment);
  void take(const std::string& line);
  void take_robot(const Json& event);
  void take_reading(const Json& event);
  bool take_reply(const Json& line);
  void log(std::uint8_t level, const std::string& text);
  /// What is due with the time: the frames of all robots as one message, the clock, diagnostics.
  void beat();

  RunConnection& run_;
  OperatorRequests requests_;
  std::string name_space_;
  std::string node_name_;
  ros2::Node node_;
  Stamps stamps_;
  std::map<std::string, RobotTopics> robots_;
  std::map<std::string, ros2::Publisher<messages::geometry_msgs::WrenchStamped>> wrenches_;  // by sensor
  ros2::Publisher<messages::tf2_msgs::TFMessage> tf_, tf_static_;
  ros2::Publisher<messages::diagnostic_msgs::DiagnosticArray> diagnostics_;
  ros2::Publisher<messages::rcl_interfaces::Log> rosout_;
  CameraViews views_;
  CameraTopics cameras_;
  HardwareCameraTopics hardware_cameras_;
  std::optional<ros2::Publisher<messages::rosgraph_msgs::Clock>> clock_;  // of a simulated clock
  std::optional<TriggerServices> services_;
  std::map<std::string, FollowAction> actions_;  // by robot
  std::int64_t status_request_ = 0;
  Diagnostics states_;
  messages::tf2_msgs::TFMessage frames_;  // not yet sent
  std::optional<Tick> newest_;
  std::optional<Tick> published_;
  std::int64_t next_diagnostics_ = 0;
};

}  // namespace mrroc::cli
