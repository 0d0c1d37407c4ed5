#include "links/ros2/goal_list.hpp"

#include <algorithm>
#include <utility>

namespace mrroc::ros2 {

namespace {

std::int64_t ns_of(const messages::builtin_interfaces::Time& time) {
  return std::int64_t{time.sec} * 1'000'000'000 + time.nanosec;
}

}  // namespace

bool GoalList::Goal::is_open() const noexcept { return status.status <= Status::STATUS_CANCELING; }
bool GoalList::Goal::is_cancelable() const noexcept { return status.status <= Status::STATUS_EXECUTING; }

const GoalList::Goal* GoalList::find(const Id& id) const noexcept {
  for (const Goal& goal : goals_)
    if (goal.status.goal_info.goal_id == id) return &goal;
  return nullptr;
}

GoalList::Goal* GoalList::find(const Id& id) noexcept { return const_cast<Goal*>(std::as_const(*this).find(id)); }

bool GoalList::is_full() const noexcept {
  return std::count_if(goals_.begin(), goals_.end(), [](const Goal& goal) { return goal.is_open(); }) >=
         std::ptrdiff_t{kMostOpen};
}

bool GoalList::add(const Id& id, const messages::builtin_interfaces::Time& stamp) {
  if (is_full() || find(id) != nullptr) return false;
  Goal goal{};
  goal.status.goal_info = {id, stamp};
  goal.status.status = Status::STATUS_ACCEPTED;
  goals_.push_back(goal);
  return true;
}

std::int8_t GoalList::status(const Id& id) const noexcept {
  const Goal* const goal = find(id);
  return goal != nullptr ? goal->status.status : Status::STATUS_UNKNOWN;
}

void GoalList::execute(const Id& id) noexcept {
  Goal* const goal = find(id);
  if (goal != nullptr && goal->status.status == Status::STATUS_ACCEPTED) goal->status.status = Status::STATUS_EXECUTING;
}

void GoalList::cancel(const Id& id) noexcept {
  Goal* const goal = find(id);
  if (goal != nullptr && goal->is_cancelable()) goal->status.status = Status::STATUS_CANCELING;
}

GoalList::CancelReply GoalList::cancel_named(const Info& request) {
  CancelReply reply;
  const bool one = request.goal_id != Id{};
  const std::int64_t stamp = ns_of(request.stamp);
  if (one && stamp == 0) {
    const Goal* const goal = find(request.goal_id);
    if (goal == nullptr) {
      reply.return_code = CancelReply::ERROR_UNKNOWN_GOAL_ID;
    } else if (!goal->is_cancelable()) {
      reply.return_code = CancelReply::ERROR_GOAL_TERMINATED;
    }
  }
  for (Goal& goal : goals_) {
    const Info& info = goal.status.goal_info;
    const bool named =
        (one && info.goal_id == request.goal_id) || (!one && stamp == 0) || (stamp != 0 && ns_of(info.stamp) <= stamp);
    if (!named || !goal.is_cancelable()) continue;
    goal.status.status = Status::STATUS_CANCELING;
    reply.goals_canceling.push_back(info);
  }
  return reply;
}

void GoalList::end(const Id& id, std::int8_t status, Clock::time_point now) {
  Goal* const goal = find(id);
  if (goal == nullptr || !goal->is_open()) return;
  goal->status.status = status;
  goal->ended = now;
}

std::vector<GoalList::Id> GoalList::expire(Clock::time_point now) {
  std::vector<Id> expired;
  auto ended = std::count_if(goals_.begin(), goals_.end(), [](const Goal& goal) { return !goal.is_open(); });
  for (auto goal = goals_.begin(); goal != goals_.end();) {
    if (!goal->is_open() && (ended > std::ptrdiff_t{kMostEnded} || now - goal->ended >= kKept)) {
      expired.push_back(goal->status.goal_info.goal_id);
      goal = goals_.erase(goal);
      --ended;
    } else {
      ++goal;
    }
  }
  return expired;
}

messages::action_msgs::GoalStatusArray GoalList::message() const {
  messages::action_msgs::GoalStatusArray message;
  for (const Goal& goal : goals_) message.status_list.push_back(goal.status);
  return message;
}

}  // namespace mrroc::ros2
