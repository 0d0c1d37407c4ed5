#include "links/ros2/goal_list.hpp"

#include <gtest/gtest.h>

namespace mrroc::ros2::goal_list_test {
namespace {

using Id = GoalList::Id;
using Info = GoalList::Info;
using Status = GoalList::Status;
using Reply = GoalList::CancelReply;

constexpr GoalList::Clock::time_point kStart{};

Id id_of(std::uint8_t number) {
  Id id;
  id.uuid[15] = number;
  return id;
}

messages::builtin_interfaces::Time at(std::int32_t seconds) {
  messages::builtin_interfaces::Time time;
  time.sec = seconds;
  return time;
}

/// The last bytes of the goals that a request names.
std::vector<int> cancelled_of(const Reply& reply) {
  std::vector<int> numbers;
  for (const Info& info : reply.goals_canceling) numbers.push_back(info.goal_id.uuid[15]);
  return numbers;
}

/// Goals 1, 2 and 3, accepted at 1, 2 and 3 s.
GoalList three_goals() {
  GoalList goals;
  for (std::uint8_t number = 1; number <= 3; ++number) {
    EXPECT_TRUE(goals.add(id_of(number), at(number)));
    goals.execute(id_of(number));
  }
  return goals;
}

TEST(GoalList, AGoalHasOneStateAfterTheOther) {
  GoalList goals;
  EXPECT_EQ(goals.status(id_of(1)), Status::STATUS_UNKNOWN);
  EXPECT_TRUE(goals.add(id_of(1), at(5)));
  EXPECT_EQ(goals.status(id_of(1)), Status::STATUS_ACCEPTED);
  goals.execute(id_of(1));
  EXPECT_EQ(goals.status(id_of(1)), Status::STATUS_EXECUTING);
  goals.cancel(id_of(1));
  goals.execute(id_of(1));
  EXPECT_EQ(goals.status(id_of(1)), Status::STATUS_CANCELING);
  goals.end(id_of(1), Status::STATUS_CANCELED, kStart);
  goals.end(id_of(1), Status::STATUS_ABORTED, kStart);
  goals.cancel(id_of(1));
  EXPECT_EQ(goals.status(id_of(1)), Status::STATUS_CANCELED);
  const auto message = goals.message();
  ASSERT_EQ(message.status_list.size(), 1u);
  EXPECT_EQ(message.status_list[0].goal_info.goal_id, id_of(1));
  EXPECT_EQ(message.status_list[0].goal_info.stamp, at(5));
}

TEST(GoalList, CancelsTheGoalsThatARequestNames) {
  EXPECT_EQ(cancelled_of(three_goals().cancel_named({})), (std::vector{1, 2, 3})) << "all";
  EXPECT_EQ(cancelled_of(three_goals().cancel_named({{}, at(2)})), (std::vector{1, 2})) << "until a time";
  EXPECT_EQ(cancelled_of(three_goals().cancel_named({id_of(2), {}})), (std::vector{2})) << "one";
  EXPECT_EQ(cancelled_of(three_goals().cancel_named({id_of(3), at(1)})), (std::vector{1, 3}))
      << "one, and until a time";
}

TEST(GoalList, ReportsWhyNoGoalIsCancelled) {
  GoalList goals = three_goals();
  EXPECT_EQ(goals.cancel_named({id_of(9), {}}).return_code, Reply::ERROR_UNKNOWN_GOAL_ID);
  goals.end(id_of(1), Status::STATUS_SUCCEEDED, kStart);
  EXPECT_EQ(goals.cancel_named({id_of(1), {}}).return_code, Reply::ERROR_GOAL_TERMINATED);
  EXPECT_EQ(goals.cancel_named({id_of(2), {}}).return_code, Reply::ERROR_NONE);
  EXPECT_EQ(goals.cancel_named({{}, at(2)}).return_code, Reply::ERROR_NONE);
  EXPECT_EQ(cancelled_of(goals.cancel_named({})), std::vector{3}) << "what is cancelled already is not cancelled again";
}

TEST(GoalList, KnownIdentitiesAndTooManyGoalsAreNotAdded) {
  GoalList goals = three_goals();
  EXPECT_FALSE(goals.add(id_of(2), at(9)));
  goals.end(id_of(2), Status::STATUS_SUCCEEDED, kStart);
  EXPECT_FALSE(goals.add(id_of(2), at(9)));
  EXPECT_TRUE(goals.add(id_of(4), at(4)));
  EXPECT_FALSE(goals.is_full());
  EXPECT_TRUE(goals.add(id_of(5), at(5)));
  EXPECT_TRUE(goals.is_full());
  EXPECT_FALSE(goals.add(id_of(6), at(6)));
}

TEST(GoalList, EndedGoalsAreKeptForATimeAndABoundedNumber) {
  GoalList goals;
  for (std::uint8_t number = 1; number <= GoalList::kMostEnded + 2; ++number) {
    EXPECT_TRUE(goals.add(id_of(number), at(number)));
    goals.end(id_of(number), Status::STATUS_SUCCEEDED, kStart + std::chrono::seconds(number));
  }
  EXPECT_TRUE(goals.add(id_of(200), at(200)));
  EXPECT_EQ(goals.expire(kStart + std::chrono::seconds(40)), (std::vector{id_of(1), id_of(2)}));
  EXPECT_EQ(goals.expire(kStart + std::chrono::seconds(3) + GoalList::kKept), std::vector{id_of(3)});
  EXPECT_EQ(goals.expire(kStart + std::chrono::hours(1)).size(), GoalList::kMostEnded - 1);
  EXPECT_EQ(goals.status(id_of(200)), Status::STATUS_ACCEPTED) << "an open goal is kept";
}

}  // namespace
}  // namespace mrroc::ros2::goal_list_test
