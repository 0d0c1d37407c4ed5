#include "cli/ros2/follow_action.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "cli/ros2/event_numbers.hpp"
#include "cli/ros2/trajectory_goal.hpp"
#include "links/ros2/ros_names.hpp"

namespace mrroc::cli {

namespace {

using Status = ros2::GoalList::Status;
using Result = messages::control_msgs::FollowJointTrajectoryResult;

std::string reply_text(const nlohmann::ordered_json& reply) {
  std::string text = reply.value("text", "");
  if (const std::string expected = reply.value("expected", ""); !expected.empty()) text += ", expected " + expected;
  return text;
}

std::int32_t code_of(const std::string& reason) {
  if (reason == "path_tolerance") return Result::PATH_TOLERANCE_VIOLATED;
  if (reason == "goal_tolerance") return Result::GOAL_TOLERANCE_VIOLATED;
  return Result::INVALID_GOAL;
}

}  // namespace

FollowAction::FollowAction(ros2::Node& node, ros2::Distro distro, const std::string& name_space, FollowedRobot robot,
                           std::filesystem::path folder, OperatorRequests& requests, Log log)
    : action_(ros2::in_namespace(ros2::in_namespace(name_space, robot.name), "follow_joint_trajectory")),
      robot_(std::move(robot)),
      folder_(std::move(folder)),
      requests_(requests),
      log_(std::move(log)),
      server_(node, action_),
      feedback_(node, distro, action_, robot_.joints) {}

bool FollowAction::is_newest(const Id& goal) const {
  return !executions_.empty() && executions_.rbegin()->second.goal == goal;
}

void FollowAction::poll(const Time& now) {
  for (const Id& goal : server_.poll(ros2::GoalList::Clock::now()))
    if (is_newest(goal)) cancel();
  while (const auto request = server_.take_goal()) take_goal(*request, now);
}

void FollowAction::take_goal(const FollowJointTrajectory::SendGoalRequest& request, const Time& now) {
  try {
    execute(request, now);
  } catch (const TrajectoryPast& error) {
    server_.accept(request, now);
    end(request.goal_id, Status::STATUS_ABORTED, Result::OLD_HEADER_TIMESTAMP, error.what());
  } catch (const std::runtime_error& error) {
    server_.reject(request);
    log_("goal of " + action_ + " rejected: " + error.what());
  }
}

void FollowAction::execute(const FollowJointTrajectory::SendGoalRequest& request, const Time& now) {
  if (!yielded_)
    throw GoalRefused("robot " + robot_.name + ": not yielded, expected a Move of the task that yields it");
  const TrajectoryGoal goal = read_goal(request.goal, robot_.joints, now);
  Execution execution{request.goal_id, PrivateFile(folder_, trajectory_file(goal)), {}, {}};
  for (const TrajectoryGoal::Point& point : goal.points) execution.times.push_back(point.time);
  server_.accept(request, now);
  const auto number =
      requests_.send({{"verb", "follow"}, {"robot", robot_.name}, {"file", execution.file.path().string()}});
  executions_.emplace(number, std::move(execution));
}

bool FollowAction::take_reply(const Json& line) {
  if (!line.contains("ok")) return false;
  const bool ok = line.value("ok", false);
  const auto number = line.value("id", std::int64_t{0});
  if (cancels_.erase(number) != 0) {
    if (!ok) log_(action_ + ": not cancelled: " + reply_text(line));
    return true;
  }
  const auto execution = executions_.find(number);
  if (execution == executions_.end()) return false;
  const Id goal = execution->second.goal;
  executions_.erase(execution);
  const std::string reason = line.value("reason", "");
  if (ok) {
    end(goal, Status::STATUS_SUCCEEDED, Result::SUCCESSFUL, "");
  } else if (reason == "cancelled") {
    server_.cancel(goal);
    end(goal, Status::STATUS_CANCELED, Result::INVALID_GOAL, reply_text(line));
  } else {
    end(goal, Status::STATUS_ABORTED, code_of(reason), reply_text(line));
  }
  // the goal that this one did not replace may have been cancelled meanwhile
  if (!executions_.empty() && executions_.rbegin()->first < number &&
      server_.status_of(executions_.rbegin()->second.goal) == Status::STATUS_CANCELING)
    cancel();
  return true;
}

void FollowAction::end(const Id& goal, std::int8_t status, std::int32_t code, const std::string& text) {
  Result result;
  result.error_code = code;
  result.error_string = text;
  server_.end(goal, status, std::move(result), ros2::GoalList::Clock::now());
}

void FollowAction::take_state(const Json& event, const Time& stamp) {
  if (executions_.empty()) return;
  Execution& execution = executions_.rbegin()->second;
  const Tick tick = event.value("tick", Tick{0});
  if (!execution.start) execution.start = tick;
  TrajectoryProgress progress;
  progress.stamp = stamp;
  progress.time = static_cast<double>(tick - std::min(*execution.start, tick)) * robot_.period;
  const auto& times = execution.times;
  const auto next = std::lower_bound(times.begin(), times.end(), progress.time);
  progress.index = static_cast<std::int32_t>(next == times.end() ? times.size() - 1 : next - times.begin());
  progress.desired = numbers_of(event, "desired");
  progress.actual = numbers_of(event, "joints");
  progress.velocity = numbers_of(event, "velocity");
  feedback_.publish(execution.goal, progress);
}

void FollowAction::cancel() {
  if (!executions_.empty()) cancels_.insert(requests_.send({{"verb", "cancel"}, {"robot", robot_.name}}));
}

void FollowAction::abort_open(const std::string& reason) {
  for (const auto& [number, execution] : executions_)
    end(execution.goal, Status::STATUS_ABORTED, Result::INVALID_GOAL, reason);
  executions_.clear();
}

}  // namespace mrroc::cli
