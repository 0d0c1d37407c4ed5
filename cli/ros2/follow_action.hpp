#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cli/ros2/operator_requests.hpp"
#include "cli/ros2/private_file.hpp"
#include "cli/ros2/trajectory_feedback.hpp"
#include "links/ros2/action_server.hpp"
#include "messages/control_msgs_cyclone/get_result_reply.hpp"
#include "messages/control_msgs_cyclone/get_result_request.hpp"
#include "messages/control_msgs_cyclone/send_goal_reply.hpp"
#include "messages/control_msgs_cyclone/send_goal_request.hpp"
#include "mrroc/types.hpp"

namespace mrroc::cli {

/// The messages of control_msgs/action/FollowJointTrajectory for ros2::ActionServer.
struct FollowJointTrajectory {
  static constexpr std::string_view kType = "control_msgs/action/FollowJointTrajectory";
  using SendGoalRequest = messages::control_msgs_cyclone::SendGoalRequest;
  using SendGoalReply = messages::control_msgs_cyclone::SendGoalReply;
  using GetResultRequest = messages::control_msgs_cyclone::GetResultRequest;
  using GetResultReply = messages::control_msgs_cyclone::GetResultReply;
};

/// The robot of an action.
struct FollowedRobot {
  std::string name;
  std::vector<std::string> joints;  ///< of its axes
  double period = 0;                ///< of its ticks, s
};

/// One robot's action control_msgs/action/FollowJointTrajectory, by the operator's verbs `follow` and `cancel`. A goal
/// is accepted while the task yields the robot, and replaces the one before. One thread.
class FollowAction {
 public:
  using Json = nlohmann::ordered_json;
  using Time = messages::builtin_interfaces::Time;
  /// Logs why a goal was rejected, for which the reply has no place.
  using Log = std::function<void(const std::string& text)>;

  /// The action is NAMESPACE/ROBOT/follow_joint_trajectory. `folder`: of the files of trajectories, which the run
  /// reads. The node and `requests` outlive it.
  FollowAction(ros2::Node& node, ros2::Distro distro, const std::string& name_space, FollowedRobot robot,
               std::filesystem::path folder, OperatorRequests& requests, Log log);

  /// Whether the task yields the robot now.
  void set_yielded(bool yielded) noexcept { yielded_ = yielded; }
  /// Takes the requests that have come. `now`: time of ROS. Does not wait.
  void poll(const Time& now);
  /// Takes the run's reply to a request; false when the line is no reply to one of these.
  bool take_reply(const Json& line);
  /// Publishes the feedback of the goal that the robot follows. `event`: a run's event "robot" of this robot.
  void take_state(const Json& event, const Time& stamp);
  /// Cancels what the robot follows.
  void cancel();
  /// Aborts all goals: the run's replies do not come.
  void abort_open(const std::string& reason);

 private:
  using Id = ros2::GoalList::Id;
  using Result = messages::control_msgs::FollowJointTrajectoryResult;
  struct Execution {
    Id goal;
    PrivateFile file;
    std::vector<double> times;  // of the points
    std::optional<Tick> start;
  };

  void take_goal(const FollowJointTrajectory::SendGoalRequest& request, const Time& now);
  void execute(const FollowJointTrajectory::SendGoalRequest& request, const Time& now);
  void end(const Id& goal, std::int8_t status, std::int32_t code, const std::string& text);
  /// The goal that the run follows, once it has taken all requests.
  bool is_newest(const Id& goal) const;

  std::string action_;
  FollowedRobot robot_;
  std::filesystem::path folder_;
  OperatorRequests& requests_;
  Log log_;
  ros2::ActionServer<FollowJointTrajectory> server_;
  TrajectoryFeedback feedback_;
  bool yielded_ = false;
  std::map<std::int64_t, Execution> executions_;  // by the number of the request
  std::set<std::int64_t> cancels_;
};

}  // namespace mrroc::cli
