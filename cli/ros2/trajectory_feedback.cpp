#include "cli/ros2/trajectory_feedback.hpp"

#include <cmath>
#include <utility>

#include "links/ros2/ros_names.hpp"

namespace mrroc::cli {

namespace {

messages::builtin_interfaces::Duration duration_of(double seconds) {
  const auto ns = std::llround(seconds * 1e9);
  messages::builtin_interfaces::Duration duration;
  duration.sec = static_cast<std::int32_t>(ns / 1'000'000'000);
  duration.nanosec = static_cast<std::uint32_t>(ns % 1'000'000'000);
  return duration;
}

template <class Message>
Message message_of(const messages::unique_identifier_msgs::UUID& goal, const TrajectoryProgress& progress,
                   const std::vector<std::string>& joints) {
  Message message;
  message.goal_id = goal;
  auto& feedback = message.feedback;
  feedback.header.stamp = progress.stamp;
  feedback.joint_names = joints;
  feedback.desired.positions = progress.desired;
  feedback.actual.positions = progress.actual;
  feedback.actual.velocities = progress.velocity;
  for (std::size_t i = 0; i < progress.desired.size(); ++i)
    feedback.error.positions.push_back(progress.desired[i] - progress.actual[i]);
  for (auto* point : {&feedback.desired, &feedback.actual, &feedback.error})
    point->time_from_start = duration_of(progress.time);
  if constexpr (requires { feedback.index; }) feedback.index = progress.index;
  return message;
}

}  // namespace

TrajectoryFeedback::TrajectoryFeedback(ros2::Node& node, ros2::Distro distro, const std::string& action,
                                       std::vector<std::string> joints)
    : joints_(std::move(joints)) {
  const std::string topic = ros2::action_name(action, "feedback");
  if (distro == ros2::Distro::kilted)
    from_kilted_.emplace(node, topic);
  else
    until_jazzy_.emplace(node, topic);
}

void TrajectoryFeedback::publish(const messages::unique_identifier_msgs::UUID& goal,
                                 const TrajectoryProgress& progress) {
  if (progress.desired.size() != joints_.size() || progress.actual.size() != joints_.size()) return;
  if (from_kilted_)
    from_kilted_->publish(
        message_of<messages::control_msgs_kilted::FollowJointTrajectoryFeedbackMessage>(goal, progress, joints_));
  else
    until_jazzy_->publish(
        message_of<messages::control_msgs::FollowJointTrajectoryFeedbackMessage>(goal, progress, joints_));
}

}  // namespace mrroc::cli
