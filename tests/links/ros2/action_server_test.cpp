// An action's server in this process. What another implementation sees of it: tests/system/ros2_action_test.py.
#include "links/ros2/action_server.hpp"

#include <gtest/gtest.h>

#include "links/ros2/service_client.hpp"
#include "messages/control_msgs_cyclone/get_result_reply.hpp"
#include "messages/control_msgs_cyclone/get_result_request.hpp"
#include "messages/control_msgs_cyclone/send_goal_reply.hpp"
#include "messages/control_msgs_cyclone/send_goal_request.hpp"

namespace mrroc::ros2::action_server_test {
namespace {

using namespace messages::control_msgs_cyclone;
using messages::action_msgs_cyclone::CancelGoalReply;
using messages::action_msgs_cyclone::CancelGoalRequest;
using Status = GoalList::Status;

constexpr int kDomain = 202;
constexpr const char* kName = "/arm/follow_joint_trajectory";

struct Types {
  static constexpr std::string_view kType = "control_msgs/action/FollowJointTrajectory";
  using SendGoalRequest = messages::control_msgs_cyclone::SendGoalRequest;
  using SendGoalReply = messages::control_msgs_cyclone::SendGoalReply;
  using GetResultRequest = messages::control_msgs_cyclone::GetResultRequest;
  using GetResultReply = messages::control_msgs_cyclone::GetResultReply;
};
using Server = ActionServer<Types>;
using Id = Server::Id;

Id id_of(std::uint8_t number) {
  Id id;
  id.uuid[0] = number;
  return id;
}

SendGoalRequest goal_of(std::uint8_t number) {
  return {.client = {}, .sequence = {}, .goal_id = id_of(number), .goal = {}};
}
GetResultRequest result_of(std::uint8_t number) { return {.client = {}, .sequence = {}, .goal_id = id_of(number)}; }

/// A client of the action.
struct Client {
  Client(dds_entity_t participant, std::uint64_t id)
      : goals(participant, action_name(kName, "send_goal"), std::string(Types::kType) + "_SendGoal", id),
        results(participant, action_name(kName, "get_result"), std::string(Types::kType) + "_GetResult", id),
        cancels(participant, action_name(kName, "cancel_goal"), "action_msgs/srv/CancelGoal", id) {}
  TestClient<SendGoalRequest, SendGoalReply> goals;
  TestClient<GetResultRequest, GetResultReply> results;
  TestClient<CancelGoalRequest, CancelGoalReply> cancels;
};

class ActionServerTest : public testing::Test {
 protected:
  /// Polls the server until `take` returns something.
  template <class Take>
  auto served(Take take) {
    return wait_for([&] {
      for (const Id& id : server.poll(now)) cancelled.push_back(id);
      return take();
    });
  }
  std::optional<SendGoalRequest> next_goal() {
    return wait_for([&] { return server.take_goal(); });
  }
  /// Sends a goal, which the server accepts.
  void start(Client& by, std::uint8_t number) {
    by.goals.send(goal_of(number));
    const auto request = next_goal();
    ASSERT_TRUE(request);
    server.accept(*request, {});
    const auto reply = wait_for([&] { return by.goals.take(); });
    ASSERT_TRUE(reply && reply->accepted);
  }

  Node node{{.domain = kDomain, .node = "mrroc_test", .interface = "lo"}};
  Server server{node, kName};
  links::Entity participant{dds_create_participant(kDomain, nullptr, nullptr), "participant", ""};
  Client client{participant.get(), 1}, other{participant.get(), 2};
  GoalList::Clock::time_point now{};
  std::vector<Id> cancelled;
};

TEST_F(ActionServerTest, AResultIsSentWhenTheGoalEnds) {
  start(client, 1);
  EXPECT_EQ(server.status_of(id_of(1)), Status::STATUS_EXECUTING);
  client.results.send(result_of(1));
  for (int look = 0; look < 20; ++look) {
    server.poll(now);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  EXPECT_FALSE(client.results.take());
  messages::control_msgs::FollowJointTrajectoryResult result;
  result.error_string = "arrived";
  server.end(id_of(1), Status::STATUS_SUCCEEDED, result, now);
  const auto reply = served([&] { return client.results.take(); });
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->status, Status::STATUS_SUCCEEDED);
  EXPECT_EQ(reply->result.error_string, "arrived");
  EXPECT_EQ(reply->sequence, 1);
  other.results.send(result_of(1));
  const auto late = served([&] { return other.results.take(); });
  ASSERT_TRUE(late);
  EXPECT_EQ(late->result.error_string, "arrived");
}

TEST_F(ActionServerTest, ResultsOfUnknownAndOfOldGoalsHaveNoStatus) {
  client.results.send(result_of(7));
  const auto unknown = served([&] { return client.results.take(); });
  ASSERT_TRUE(unknown);
  EXPECT_EQ(unknown->status, Status::STATUS_UNKNOWN);
  start(client, 1);
  server.end(id_of(1), Status::STATUS_SUCCEEDED, {}, now);
  now += GoalList::kKept;
  client.results.send(result_of(1));
  const auto old = served([&] { return client.results.take(); });
  ASSERT_TRUE(old);
  EXPECT_EQ(old->status, Status::STATUS_UNKNOWN);
}

TEST_F(ActionServerTest, ClientsGetTheRepliesToTheirOwnRequests) {
  start(client, 1);
  start(other, 2);
  client.results.send(result_of(1));
  other.results.send(result_of(2));
  server.end(id_of(2), Status::STATUS_SUCCEEDED, {}, now);
  const auto second = served([&] { return other.results.take(); });
  ASSERT_TRUE(second);
  EXPECT_EQ(second->status, Status::STATUS_SUCCEEDED);
  EXPECT_FALSE(client.results.take());
  server.end(id_of(1), Status::STATUS_ABORTED, {}, now);
  const auto first = served([&] { return client.results.take(); });
  ASSERT_TRUE(first);
  EXPECT_EQ(first->status, Status::STATUS_ABORTED);
}

TEST_F(ActionServerTest, CancelledGoalsAreReturnedOnce) {
  start(client, 1);
  other.cancels.send({});
  const auto reply = served([&] { return other.cancels.take(); });
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->return_code, CancelGoalReply::ERROR_NONE);
  ASSERT_EQ(reply->goals_canceling.size(), 1u);
  EXPECT_EQ(reply->goals_canceling[0].goal_id, id_of(1));
  EXPECT_EQ(cancelled, std::vector{id_of(1)});
  client.cancels.send({.client = {}, .sequence = {}, .goal_info = {id_of(1), {}}});
  const auto again = served([&] { return client.cancels.take(); });
  ASSERT_TRUE(again);
  EXPECT_EQ(again->return_code, CancelGoalReply::ERROR_GOAL_TERMINATED);
  EXPECT_EQ(cancelled.size(), 1u);
}

TEST_F(ActionServerTest, AKnownGoalIsRejected) {
  start(client, 1);
  other.goals.send(goal_of(1));
  const auto reply = wait_for([&] {
    EXPECT_FALSE(server.take_goal());
    return other.goals.take();
  });
  ASSERT_TRUE(reply);
  EXPECT_FALSE(reply->accepted);
  EXPECT_EQ(server.status_of(id_of(1)), Status::STATUS_EXECUTING);
}

TEST_F(ActionServerTest, LateSubscribersReceiveTheStatus) {
  start(client, 1);
  server.end(id_of(1), Status::STATUS_SUCCEEDED, {}, now);
  start(client, 2);
  TestReader<messages::action_msgs::GoalStatusArray> reader(
      participant.get(), "rt/arm/follow_joint_trajectory/_action/status", "action_msgs/msg/GoalStatusArray", true);
  const auto status = wait_for([&] { return reader.take(); });
  ASSERT_TRUE(status);
  ASSERT_EQ(status->status_list.size(), 2u);
  EXPECT_EQ(status->status_list[0].status, Status::STATUS_SUCCEEDED);
  EXPECT_EQ(status->status_list[1].status, Status::STATUS_EXECUTING);
}

TEST_F(ActionServerTest, AFloodIsBounded) {
  for (std::uint8_t number = 1; number <= GoalList::kMostOpen; ++number) start(client, number);
  other.goals.send(goal_of(100));
  for (std::size_t i = 0; i < Server::kMostWaiting + 200; ++i) {
    client.results.send(result_of(1));
    client.goals.write(CdrBytes(11));
    if (i % 8 == 0) server.poll(now);
  }
  const auto refused = served([&] { return client.results.take(); });
  ASSERT_TRUE(refused) << "more requests than wait are refused";
  EXPECT_EQ(refused->status, Status::STATUS_UNKNOWN);
  EXPECT_FALSE(server.take_goal()) << "as many goals as may be are open";
  server.end(id_of(1), Status::STATUS_SUCCEEDED, {}, now);
  client.goals.send(goal_of(101));
  const auto next = next_goal();
  ASSERT_TRUE(next);
  EXPECT_EQ(next->goal_id, id_of(101));
  EXPECT_GT(server.malformed(), 0u);
}

}  // namespace
}  // namespace mrroc::ros2::action_server_test
