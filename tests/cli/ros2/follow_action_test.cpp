// The action of one robot, without a run: its side of the operator's socket is a list of lines.
#include "cli/ros2/follow_action.hpp"

#include <gtest/gtest.h>

#include "config/entries/trajectory_entry.hpp"
#include "links/ros2/service_client.hpp"
#include "mrroc/testing/scratch_folder.hpp"

namespace mrroc::cli::follow_action_test {
namespace {

using Json = nlohmann::ordered_json;
using Status = ros2::GoalList::Status;
using Result = messages::control_msgs::FollowJointTrajectoryResult;
using Types = FollowJointTrajectory;
using messages::action_msgs_cyclone::CancelGoalReply;
using messages::action_msgs_cyclone::CancelGoalRequest;
using Feedback = messages::control_msgs_kilted::FollowJointTrajectoryFeedbackMessage;

constexpr int kDomain = 203;
constexpr const char* kAction = "/arm/follow_joint_trajectory";

messages::builtin_interfaces::Time at(std::int32_t sec) {
  messages::builtin_interfaces::Time time;
  time.sec = sec;
  return time;
}

/// Points at 1 and 2 s.
Types::SendGoalRequest goal_of(std::uint8_t number) {
  Types::SendGoalRequest request;
  request.goal_id.uuid[0] = number;
  request.goal.trajectory.joint_names = {"b", "a"};
  for (const std::int32_t second : {1, 2}) {
    messages::trajectory_msgs::JointTrajectoryPoint point;
    point.positions = {2.0 * second, 1.0 * second};
    point.time_from_start.sec = second;
    request.goal.trajectory.points.push_back(point);
  }
  return request;
}

class FollowActionTest : public testing::Test {
 protected:
  FollowActionTest() { action.set_yielded(true); }

  /// Polls the action until `take` returns something.
  template <class Take>
  auto served(Take take) {
    return ros2::wait_for([&] {
      action.poll(at(100));
      return take();
    });
  }
  /// Whether the goal is accepted. Its result is requested, too.
  bool send(const Types::SendGoalRequest& request) {
    goals.send(request);
    const auto reply = served([&] { return goals.take(); });
    EXPECT_TRUE(reply);
    Types::GetResultRequest result;
    result.goal_id = request.goal_id;
    results.send(result);
    return reply && reply->accepted;
  }
  void reply(std::int64_t id, const Json& fields) {
    Json line{{"id", id}};
    line.update(fields);
    EXPECT_TRUE(action.take_reply(line)) << line;
  }
  Types::GetResultReply next_result() {
    const auto result = served([&] { return results.take(); });
    EXPECT_TRUE(result);
    return result.value_or(Types::GetResultReply{});
  }
  void expect_result(std::int8_t status, std::int32_t code, const std::string& text) {
    const auto result = next_result();
    EXPECT_EQ(result.status, status);
    EXPECT_EQ(result.result.error_code, code);
    EXPECT_EQ(result.result.error_string, text);
  }
  std::size_t files() const {
    return static_cast<std::size_t>(
        std::distance(std::filesystem::directory_iterator(folder.path()), std::filesystem::directory_iterator()));
  }

  task_test::ScratchFolder folder;
  std::vector<Json> sent;         // to the run
  std::vector<std::string> logs;  // of rejected goals
  OperatorRequests requests{[this](const std::string& line) { sent.push_back(Json::parse(line)); }};
  ros2::Node node{{.domain = kDomain, .node = "mrroc_test", .interface = "lo"}};
  FollowAction action{node,
                      ros2::Distro::kilted,
                      "/",
                      {"arm", {"a", "b"}, 0.5},
                      folder.path(),
                      requests,
                      [this](const std::string& text) { logs.push_back(text); }};
  links::Entity participant{dds_create_participant(kDomain, nullptr, nullptr), "participant", ""};
  ros2::TestClient<Types::SendGoalRequest, Types::SendGoalReply> goals{
      participant.get(), ros2::action_name(kAction, "send_goal"), std::string(Types::kType) + "_SendGoal", 1};
  ros2::TestClient<Types::GetResultRequest, Types::GetResultReply> results{
      participant.get(), ros2::action_name(kAction, "get_result"), std::string(Types::kType) + "_GetResult", 1};
  ros2::TestClient<CancelGoalRequest, CancelGoalReply> cancels{
      participant.get(), ros2::action_name(kAction, "cancel_goal"), "action_msgs/srv/CancelGoal", 1};
};

TEST_F(FollowActionTest, AGoalBecomesARequestToTheRun) {
  ASSERT_TRUE(send(goal_of(1)));
  ASSERT_EQ(sent.size(), 1u);
  EXPECT_EQ(sent[0].at("verb"), "follow");
  EXPECT_EQ(sent[0].at("robot"), "arm");
  const auto read = config::load_trajectory(sent[0].at("file").get<std::string>(), 2);
  ASSERT_EQ(read->points(), 2U);
  EXPECT_EQ(read->order(), JointTrajectory::Order::positions);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(read->time(i), static_cast<double>(i) + 1);
    EXPECT_EQ(read->position(i, 0), static_cast<double>(i) + 1);
    EXPECT_EQ(read->position(i, 1), 2 * (static_cast<double>(i) + 1));
    EXPECT_EQ(read->path_tolerance(i), 0);
    EXPECT_EQ(read->goal_tolerance(i), 0);
  }
  reply(sent[0].at("id"), {{"ok", true}});
  expect_result(Status::STATUS_SUCCEEDED, Result::SUCCESSFUL, "");
  EXPECT_EQ(files(), 0u);
}

TEST_F(FollowActionTest, TheReasonOfTheRunIsTheResult) {
  const std::vector<std::tuple<const char*, std::int8_t, std::int32_t>> cases{
      {"path_tolerance", Status::STATUS_ABORTED, Result::PATH_TOLERANCE_VIOLATED},
      {"goal_tolerance", Status::STATUS_ABORTED, Result::GOAL_TOLERANCE_VIOLATED},
      {"invalid_trajectory", Status::STATUS_ABORTED, Result::INVALID_GOAL},
      {"taken_back", Status::STATUS_ABORTED, Result::INVALID_GOAL},
      {"cancelled", Status::STATUS_CANCELED, Result::INVALID_GOAL}};
  std::uint8_t number = 0;
  for (const auto& [reason, status, code] : cases) {
    ASSERT_TRUE(send(goal_of(++number)));
    reply(sent.back().at("id"), {{"ok", false}, {"reason", reason}, {"text", "axis 2: 0.3"}, {"expected", "0.1"}});
    expect_result(status, code, "axis 2: 0.3, expected 0.1");
  }
}

TEST_F(FollowActionTest, WithoutTheTasksYieldAGoalIsRejected) {
  action.set_yielded(false);
  EXPECT_FALSE(send(goal_of(1)));
  EXPECT_TRUE(sent.empty());
  ASSERT_EQ(logs.size(), 1u);
  EXPECT_NE(logs[0].find(kAction), std::string::npos);
  EXPECT_NE(logs[0].find("not yielded"), std::string::npos);
}

TEST_F(FollowActionTest, AnInvalidGoalIsRejectedWithALineOfTheLog) {
  auto request = goal_of(1);
  request.goal.trajectory.joint_names[0] = "c";
  EXPECT_FALSE(send(request));
  ASSERT_EQ(logs.size(), 1u);
  EXPECT_NE(logs[0].find("joint_names: without 'b'"), std::string::npos) << logs[0];
  EXPECT_EQ(files(), 0u);
}

TEST_F(FollowActionTest, APastTrajectoryIsAborted) {
  auto request = goal_of(1);
  request.goal.trajectory.header.stamp = at(50);
  EXPECT_TRUE(send(request));
  const auto result = next_result();
  EXPECT_EQ(result.status, Status::STATUS_ABORTED);
  EXPECT_EQ(result.result.error_code, Result::OLD_HEADER_TIMESTAMP);
  EXPECT_TRUE(sent.empty());
}

TEST_F(FollowActionTest, ACancelledGoalIsCancelledInTheRun) {
  ASSERT_TRUE(send(goal_of(1)));
  cancels.send({});
  ASSERT_TRUE(served([&] { return cancels.take(); }));
  ASSERT_EQ(sent.size(), 2u);
  EXPECT_EQ(sent[1].at("verb"), "cancel");
  EXPECT_EQ(sent[1].at("robot"), "arm");
  reply(sent[1].at("id"), {{"ok", true}});
  reply(sent[0].at("id"), {{"ok", false}, {"reason", "cancelled"}, {"text", "cancelled"}});
  expect_result(Status::STATUS_CANCELED, Result::INVALID_GOAL, "cancelled");
}

TEST_F(FollowActionTest, TheCancellationOfAReplacedGoalDoesNotReachTheNext) {
  ASSERT_TRUE(send(goal_of(1)));
  ASSERT_TRUE(send(goal_of(2)));
  CancelGoalRequest first;
  first.goal_info.goal_id = goal_of(1).goal_id;
  cancels.send(first);
  ASSERT_TRUE(served([&] { return cancels.take(); }));
  EXPECT_EQ(sent.size(), 2u) << "the run follows the second goal";
  // the run refuses the second: it still follows the first, which is to be cancelled
  reply(sent[1].at("id"), {{"ok", false}, {"reason", "invalid_trajectory"}, {"text", "too fast"}});
  expect_result(Status::STATUS_ABORTED, Result::INVALID_GOAL, "too fast");
  ASSERT_EQ(sent.size(), 3u);
  EXPECT_EQ(sent[2].at("verb"), "cancel");
}

TEST_F(FollowActionTest, EachStateIsFeedback) {
  ros2::TestReader<Feedback> reader(participant.get(), "rt/arm/follow_joint_trajectory/_action/feedback",
                                    std::string(Feedback::kType));
  Json state{{"event", "robot"},     {"name", "arm"},         {"tick", 10},
             {"joints", {1.0, 2.0}}, {"desired", {1.5, 1.0}}, {"velocity", {0.0, 0.1}}};
  action.take_state(state, at(1));
  ASSERT_TRUE(send(goal_of(7)));
  std::optional<Feedback> feedback;
  for (const Tick tick : {10, 13}) {
    state["tick"] = tick;
    action.take_state(state, at(1));
    feedback = ros2::wait_for([&] { return reader.take(); });
    ASSERT_TRUE(feedback);
  }
  EXPECT_EQ(feedback->goal_id, goal_of(7).goal_id);
  EXPECT_EQ(feedback->feedback.joint_names, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(feedback->feedback.error.positions, (std::vector{0.5, -1.0}));
  EXPECT_EQ(feedback->feedback.actual.velocities, (std::vector{0.0, 0.1}));
  EXPECT_EQ(feedback->feedback.actual.time_from_start.sec, 1) << "three ticks";
  EXPECT_EQ(feedback->feedback.index, 1);
  for (const char* odd : {"{}", R"({"tick":5,"joints":[1],"desired":"x"})"})
    EXPECT_NO_THROW(action.take_state(Json::parse(odd), at(1))) << odd;
}

TEST_F(FollowActionTest, OpenGoalsAreAbortedWithTheRun) {
  ASSERT_TRUE(send(goal_of(1)));
  ASSERT_TRUE(send(goal_of(2)));
  action.abort_open("the run has ended");
  for (int goal = 0; goal < 2; ++goal) expect_result(Status::STATUS_ABORTED, Result::INVALID_GOAL, "the run has ended");
  EXPECT_EQ(files(), 0u);
}

TEST_F(FollowActionTest, AFloodOfGoalsIsBounded) {
  for (std::uint8_t number = 1; number < 200; ++number) {
    goals.send(goal_of(number));
    action.poll(at(100));
  }
  ASSERT_TRUE(served([&] { return sent.size() == ros2::GoalList::kMostOpen; }));
  EXPECT_EQ(files(), ros2::GoalList::kMostOpen);
  const std::vector<Json> open = sent;
  for (const Json& line : open) reply(line.at("id"), {{"ok", false}, {"reason", "cancelled"}, {"text", ""}});
  EXPECT_TRUE(served([&] { return sent.size() > open.size(); })) << "the newest goals of the flood wait";
  EXPECT_FALSE(action.take_reply({{"id", 10000}, {"ok", true}}));
}

}  // namespace
}  // namespace mrroc::cli::follow_action_test
