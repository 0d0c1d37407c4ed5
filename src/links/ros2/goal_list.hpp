#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "messages/action_msgs/goal_info.hpp"
#include "messages/action_msgs/goal_status.hpp"
#include "messages/action_msgs/goal_status_array.hpp"
#include "messages/action_msgs_cyclone/cancel_goal_reply.hpp"

namespace mrroc::ros2 {

/// The goals of one action with their states, as rcl_action has them: those that are open, and those that ended within
/// the last kKept, of which the newest kMostEnded. One thread.
class GoalList {
 public:
  using Info = messages::action_msgs::GoalInfo;
  using Id = messages::unique_identifier_msgs::UUID;
  using Status = messages::action_msgs::GoalStatus;
  using CancelReply = messages::action_msgs_cyclone::CancelGoalReply;
  using Clock = std::chrono::steady_clock;

  static constexpr std::size_t kMostOpen = 4;
  static constexpr std::size_t kMostEnded = 32;
  static constexpr std::chrono::seconds kKept{60};

  /// Adds a goal, ACCEPTED at `stamp`; false when its identity is known or kMostOpen goals are open.
  bool add(const Id& id, const messages::builtin_interfaces::Time& stamp);
  /// Of GoalStatus; STATUS_UNKNOWN: no such goal.
  std::int8_t status(const Id& id) const noexcept;
  bool is_full() const noexcept;
  /// The states before the end: EXECUTING of an accepted goal, CANCELING of both. Other goals keep theirs.
  void execute(const Id& id) noexcept;
  void cancel(const Id& id) noexcept;
  /// Makes the goals that a request of action_msgs/srv/CancelGoal names CANCELING, and lists them.
  CancelReply cancel_named(const Info& request);
  /// The final state of an open goal.
  void end(const Id& id, std::int8_t status, Clock::time_point now);
  /// Removes ended goals that are no longer kept, and returns them.
  std::vector<Id> expire(Clock::time_point now);
  messages::action_msgs::GoalStatusArray message() const;

 private:
  struct Goal {
    Status status;
    Clock::time_point ended;
    bool is_open() const noexcept;
    bool is_cancelable() const noexcept;
  };
  const Goal* find(const Id& id) const noexcept;
  Goal* find(const Id& id) noexcept;

  std::vector<Goal> goals_;  // in the order of their acceptance
};

}  // namespace mrroc::ros2
