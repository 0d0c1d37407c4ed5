#include <gtest/gtest.h>

#include <stdexcept>

#include "cli/operator/operator_rig.hpp"
#include "cli/operator/operator_service.hpp"
#include "cli/operator/operator_state.hpp"

namespace mrroc::cli::operator_emergency_stop_test {
namespace {

/// A run with another host, which follows presses and resets when the test lets it.
struct TwoHostsRig : OperatorRig {
  explicit TwoHostsRig(config::ClockMode mode) : OperatorRig(asking_arm(mode)) {
    events.emergency_stop_arrives_when([this] { return presses == stop().presses() && resets == stop().resets(); });
    next_tick();
  }
  static config::Deployment asking_arm(config::ClockMode mode) {
    config::Deployment deployment = asking_deployment(mode);
    config::RobotEntry arm;
    arm.name = "arm";
    arm.type = "irb6";
    deployment.robots = {arm};
    return deployment;
  }
  void follow() { presses = stop().presses(), resets = stop().resets(); }
  clock::EmergencyStop& stop() { return clock.emergency_stop(); }
  /// The last reply after one more tick.
  VerbReply reply_to(const char* line) {
    request(kA, line);
    next_tick();
    return replies[kA.number].back();
  }

  std::uint32_t presses = 0, resets = 0;  ///< that have arrived
};

TEST(OperatorEmergencyStop, ResetIsAnsweredWhenItHasReachedEveryHost) {
  TwoHostsRig rig(config::ClockMode::real);
  rig.reply_to("estop");
  rig.follow();
  rig.request(kA, "reset");
  for (int i = 0; i < 5; ++i) rig.next_tick();
  ASSERT_EQ(rig.replies[kA.number].size(), 1U) << "only estop";
  EXPECT_EQ(rig.stop().resets(), 1U);
  const Tick reset_at = rig.noted.back().tick;
  rig.follow();
  rig.next_tick();
  ASSERT_EQ(rig.replies[kA.number].size(), 2U);
  EXPECT_TRUE(rig.replies[kA.number].back().ok());
  EXPECT_EQ(rig.replies[kA.number].back().tick, reset_at) << "it took effect before";
  rig.request(kA, "estop");
  rig.request(kA, "reset");
  rig.next_tick();
  rig.service.end(0, "");
  EXPECT_EQ(rig.replies[kA.number].back().refusal, Refusal::ended);
}

TEST(OperatorEmergencyStop, ResetTakesEffectWhenEveryServoHasCheckedTheStop) {
  for (const config::ClockMode clock : {config::ClockMode::paced, config::ClockMode::real}) {
    TwoHostsRig rig(clock);
    rig.request(kA, "estop");
    rig.request(kA, "reset");
    for (int i = 0; i < 10; ++i) rig.next_tick();
    EXPECT_EQ(rig.stop().presses(), 1U);
    EXPECT_EQ(rig.stop().resets(), 0U) << "the other host has not received the stop";
    rig.follow();
    rig.next_tick();
    EXPECT_EQ(rig.stop().resets(), 0U)
        << "it has arrived at this tick at the latest: the servo checks it at the next one";
    for (int i = 0; i < 2; ++i) rig.next_tick();
    EXPECT_EQ(rig.stop().resets(), 1U);
    EXPECT_FALSE(rig.events.emergency_stopped());
  }
}

TEST(OperatorEmergencyStop, ResetDoesNotReleaseALaterEmergencyStop) {
  TwoHostsRig rig(config::ClockMode::real);
  rig.request(kA, "estop");
  rig.request(kA, "reset");
  rig.next_tick();
  rig.request(kB, "estop");
  rig.follow();
  for (int i = 0; i < 5; ++i) rig.next_tick();
  EXPECT_EQ(rig.stop().resets(), 0U);
  EXPECT_TRUE(rig.events.emergency_stopped());
  EXPECT_EQ(rig.replies[kA.number].back().refusal, Refusal::not_allowed) << to_text(rig.replies[kA.number].back());
  for (const config::Event& event : rig.noted) EXPECT_NE(event.command, "reset");
  rig.request(kA, "reset");
  for (int i = 0; i < 5; ++i) rig.next_tick();
  EXPECT_EQ(rig.stop().resets(), 1U);
}

/// A robot of another host that has not received the stop would obey them.
TEST(OperatorEmergencyStop, OrdersThatPowerOrMoveARobotAreRefusedUntilTheResetHasArrived) {
  const char* const motions[] = {"recover arm", "synchronise arm", "jog arm column 0.1", "step arm column 0.1",
                                 "go arm home"};
  TwoHostsRig rig(config::ClockMode::real);
  EXPECT_TRUE(rig.request(kA, "recover arm").empty()) << "under way at the press";
  rig.request(kB, "estop");
  rig.next_tick();
  EXPECT_EQ(rig.replies[kA.number].back().refusal, Refusal::not_allowed);
  for (const char* line : motions) {
    const VerbReply reply = rig.reply_to(line);
    EXPECT_EQ(reply.refusal, Refusal::not_allowed) << line;
    EXPECT_NE(reply.text.find("the emergency stop is pressed"), std::string::npos) << to_text(reply);
    EXPECT_FALSE(reply.expected.empty()) << line;
  }
  rig.follow();
  EXPECT_EQ(rig.reply_to("recover arm").refusal, Refusal::not_allowed) << "the stop has arrived, but is not reset";
  rig.request(kB, "reset");
  for (int i = 0; i < 5; ++i) rig.next_tick();
  EXPECT_EQ(rig.stop().resets(), 1U);
  for (const char* line : motions) EXPECT_EQ(rig.reply_to(line).refusal, Refusal::not_allowed) << line;
  for (const config::Event& event : rig.noted) EXPECT_FALSE(event.command == "recover");
  rig.follow();
  const std::size_t replies = rig.replies[kA.number].size();
  rig.reply_to("recover arm");
  EXPECT_EQ(rig.replies[kA.number].size(), replies) << "the robot has received it and answers";
  EXPECT_EQ(rig.noted.back().command, "recover");
}

TEST(OperatorEmergencyStop, RefusedEventOfTheDeploymentIsShownAndNotNoted) {
  config::Deployment deployment = TwoHostsRig::asking_arm(config::ClockMode::lockstep);
  config::Event recover{.tick = 2, .command = "recover"};
  recover.order.robot = "arm";
  deployment.events = {{.tick = 1, .command = "estop"}, recover};
  OperatorRig rig(deployment);
  for (int i = 0; i < 3; ++i) rig.next_tick();
  EXPECT_EQ(rig.noted.back().command, "estop");
  EXPECT_NE(rig.shown.back().find("recover by an event of the deployment at tick 2 is refused"), std::string::npos)
      << rig.shown.back();
}

}  // namespace
}  // namespace mrroc::cli::operator_emergency_stop_test
