#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "links/ros2/goal_list.hpp"
#include "links/ros2/publisher.hpp"
#include "links/ros2/ros_names.hpp"
#include "links/ros2/service.hpp"
#include "messages/action_msgs_cyclone/cancel_goal_request.hpp"

namespace mrroc::ros2 {

/// The server of an action: the services `send_goal`, `get_result` and `cancel_goal` and the topic `status` below
/// NAME/_action, with the QoS of rcl_action. Feedback is a publisher of `action_name(name, "feedback")`. A goal that is
/// accepted executes at once; a request of its result waits until `end`. The memory of goals and requests is bounded.
/// One thread.
///
/// `Types`: the messages SendGoalRequest, SendGoalReply, GetResultRequest and GetResultReply, with `client` and
/// `sequence`, and the action's name kType, "control_msgs/action/FollowJointTrajectory".
template <class Types>
class ActionServer {
 public:
  using GoalRequest = typename Types::SendGoalRequest;
  using ResultReply = typename Types::GetResultReply;
  using Id = GoalList::Id;
  using Time = messages::builtin_interfaces::Time;

  static constexpr std::size_t kMostWaiting = 64;  ///< requests of results; further ones are answered STATUS_UNKNOWN
  static constexpr int kMostAtOnce = 32;  ///< requests of one service that a call takes: a flood does not hold it

  /// `name`: absolute, "/arm/follow_joint_trajectory". Throws SystemError (resources). The node outlives it, and shows
  /// it from its next `announce` on.
  ActionServer(Node& node, const std::string& name)
      : goal_(node, action_name(name, "send_goal"), std::string(Types::kType) + "_SendGoal"),
        result_(node, action_name(name, "get_result"), std::string(Types::kType) + "_GetResult"),
        cancel_(node, action_name(name, "cancel_goal"), "action_msgs/srv/CancelGoal"),
        status_(node, action_name(name, "status"), Durability::last) {}

  /// The next goal, to be accepted or rejected at once; nothing while as many are open as may be. Goals whose identity
  /// is known are rejected here.
  std::optional<GoalRequest> take_goal() {
    for (int taken = 0; taken < kMostAtOnce && !goals_.is_full(); ++taken) {
      auto request = goal_.take();
      if (!request || status_of(request->goal_id) == GoalList::Status::STATUS_UNKNOWN) return request;
      reject(*request);
    }
    return std::nullopt;
  }
  void accept(const GoalRequest& request, const Time& stamp) {
    typename Types::SendGoalReply reply;
    reply.accepted = goals_.add(request.goal_id, stamp);
    reply.stamp = stamp;
    goal_.reply(request, reply);
    goals_.execute(request.goal_id);
    status_.publish(goals_.message());
  }
  void reject(const GoalRequest& request) { goal_.reply(request, {}); }

  /// Answers requests of results and of cancellation, and forgets old goals. Returns the goals that are to be
  /// cancelled. Does not wait.
  std::vector<Id> poll(GoalList::Clock::time_point now) {
    for (const Id& id : goals_.expire(now)) std::erase_if(results_, [&](const auto& each) { return each.first == id; });
    for (int taken = 0; taken < kMostAtOnce; ++taken) {
      const auto request = result_.take();
      if (!request) break;
      answer(*request);
    }
    std::vector<Id> cancelled;
    for (int taken = 0; taken < kMostAtOnce; ++taken) {
      const auto request = cancel_.take();
      if (!request) break;
      const GoalList::CancelReply reply = goals_.cancel_named(request->goal_info);
      for (const GoalList::Info& info : reply.goals_canceling) cancelled.push_back(info.goal_id);
      cancel_.reply(*request, reply);
    }
    if (!cancelled.empty()) status_.publish(goals_.message());
    return cancelled;
  }

  std::int8_t status_of(const Id& id) const noexcept { return goals_.status(id); }
  /// Makes an open goal CANCELING without a request of a client.
  void cancel(const Id& id) {
    goals_.cancel(id);
    status_.publish(goals_.message());
  }
  /// Ends an open goal: STATUS_SUCCEEDED, STATUS_CANCELED or STATUS_ABORTED.
  void end(const Id& id, std::int8_t status, decltype(ResultReply::result) result, GoalList::Clock::time_point now) {
    goals_.end(id, status, now);
    status_.publish(goals_.message());
    ResultReply reply;
    reply.status = status;
    reply.result = std::move(result);
    std::erase_if(waiting_, [&](const ResultRequest& request) {
      if (request.goal_id != id) return false;
      result_.reply(request, reply);
      return true;
    });
    results_.emplace_back(id, std::move(reply));
  }
  std::uint64_t malformed() const noexcept { return goal_.malformed() + result_.malformed() + cancel_.malformed(); }

 private:
  using ResultRequest = typename Types::GetResultRequest;

  void answer(const ResultRequest& request) {
    const auto ended =
        std::find_if(results_.begin(), results_.end(), [&](const auto& each) { return each.first == request.goal_id; });
    if (ended != results_.end()) {
      result_.reply(request, ended->second);
    } else if (status_of(request.goal_id) != GoalList::Status::STATUS_UNKNOWN && waiting_.size() < kMostWaiting) {
      waiting_.push_back(request);
    } else {
      result_.reply(request, {});
    }
  }

  Service<GoalRequest, typename Types::SendGoalReply> goal_;
  Service<ResultRequest, ResultReply> result_;
  Service<messages::action_msgs_cyclone::CancelGoalRequest, GoalList::CancelReply> cancel_;
  Publisher<messages::action_msgs::GoalStatusArray> status_;
  GoalList goals_;
  std::vector<std::pair<Id, ResultReply>> results_;  // of ended goals
  std::vector<ResultRequest> waiting_;
};

}  // namespace mrroc::ros2
