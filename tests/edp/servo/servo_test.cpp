#include "edp/servo/servo.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "edp/rig.hpp"

namespace mrroc::edp::servo_test {
namespace {

TEST(Servo, StartsStoppedWithTheDrivesOff) {
  Rig<Slide> rig(false);
  rig.run(10);
  EXPECT_FALSE(rig.hardware.powered);
  const RobotState state = rig.query();
  EXPECT_FALSE(state.enabled);
  EXPECT_NEAR(state.joints[0], 0.25, 1e-4);
  EXPECT_EQ(state.desired_joints, state.joints);
  EXPECT_EQ(state.desired_tick, state.tick);
  ASSERT_TRUE(rig.send(joint_command(one(0.3), 1000, 1)));
  EXPECT_EQ(rig.answer.state.error.code, ErrorCode::not_enabled);
}

TEST(Servo, SwitchingOnMakesTheMeasuredPositionTheDesiredOne) {
  Rig<Slide> rig(false);
  rig.run(3);
  const double measured = rig.seen().joints[0];
  rig.effector.enable(true);
  rig.run(500);
  EXPECT_TRUE(rig.hardware.powered);
  EXPECT_EQ(rig.seen().desired.position[0], measured);
  EXPECT_EQ(rig.seen().joints[0], measured);  // no jump, not even by one encoder increment
}

TEST(Servo, DrivesThatLoseTheirPositionsStopTheRobot) {
  Rig<Slide> rig;
  rig.hardware.positions_lost = true;
  rig.run(100);
  EXPECT_EQ(rig.seen().fault.code, ErrorCode::drive_fault);
  EXPECT_FALSE(rig.hardware.powered);
}

TEST(Servo, TooLargeAFollowingErrorStopsTheRobotAndSwitchesTheDrivesOff) {
  Rig<Slide> rig;
  rig.send(joint_command(one(1.25), 1500, 1500));
  rig.run(400);
  rig.hardware.jam = true;
  rig.run(500);
  ASSERT_EQ(rig.seen().fault.code, ErrorCode::following_error);
  EXPECT_EQ(rig.seen().fault.axis, 0);
  EXPECT_GT(std::get<Excess>(rig.seen().fault.detail).value, 30);
  EXPECT_FALSE(rig.hardware.powered);
  // the reply leaves at once, with the error; nothing is reported twice
  ASSERT_EQ(rig.replies.size(), 1u);
  EXPECT_EQ(rig.replies[0].state.tick, rig.seen().fault.tick);
  EXPECT_EQ(rig.replies[0].state.error.error_class, ErrorClass::hardware);
  EXPECT_EQ(rig.replies[0].state.error.code, ErrorCode::following_error);
  EXPECT_NE(rig.replies[0].state.error.detail.view().find("axis 1 (x)"), std::string_view::npos);
  // and every later one carries it
  ASSERT_TRUE(rig.send(joint_command(one(0.3), 1000, 1)));
  EXPECT_EQ(rig.answer.state.error.code, ErrorCode::following_error);
  EXPECT_EQ(rig.query().error.code, ErrorCode::following_error);
}

TEST(Servo, MovesFromItsPositionAfterRecovery) {
  Rig<Slide> rig;
  rig.send(joint_command(one(1.25), 1500, 1500));
  rig.run(400);
  rig.hardware.fault = ErrorCode::drive_fault;
  rig.run(1);
  EXPECT_FALSE(rig.hardware.powered);  // category 0: at once
  rig.run(300);
  EXPECT_EQ(rig.query().error.code, ErrorCode::drive_fault);

  rig.effector.enable(true);  // the fault persists
  rig.run(5);
  EXPECT_FALSE(rig.hardware.powered);
  rig.hardware.fault = ErrorCode::none;
  const double stands = rig.seen().joints[0];
  rig.effector.enable(true);
  rig.tick();
  const RobotState state = rig.query();
  EXPECT_EQ(state.error.code, ErrorCode::none);
  EXPECT_TRUE(state.enabled);
  EXPECT_EQ(state.desired_joints[0], stands);
  RobotCommand command = joint_command(one(0.1), 1000, 1000);
  command.relative = true;
  ASSERT_FALSE(rig.send(command));
  rig.run(1500);
  EXPECT_NEAR(rig.seen().joints[0], stands + 0.1, 2e-4);
}

TEST(Servo, SwitchingOffDuringAMotionStopsFirstAndAnswersTheCommand) {
  Rig<Slide> rig;
  rig.send(joint_command(one(1.25), 1500, 1500));
  rig.run(500);
  rig.effector.enable(false);
  rig.tick();
  EXPECT_TRUE(rig.hardware.powered);
  ASSERT_EQ(rig.replies.size(), 1u);
  EXPECT_EQ(rig.replies[0].state.error.code, ErrorCode::not_enabled);
  rig.run(300);
  EXPECT_FALSE(rig.hardware.powered);
}

TEST(Servo, CountsMissedTicksAndKeepsTheGrid) {
  Rig<Slide> rig;
  rig.send(joint_command(one(0.5), 500, 500));
  rig.run(100);
  rig.now += 3;  // three ticks of the grid that were not executed
  rig.run(396);
  EXPECT_EQ(rig.seen().counters.missed, 3u);
  ASSERT_TRUE(rig.replies.empty());
  rig.run(1);
  ASSERT_EQ(rig.replies.size(), 1u);
  EXPECT_EQ(rig.replies[0].state.tick, 500u);
  EXPECT_EQ(rig.seen().desired.position[0], 0.5);
}

/// The last check: a macrostep that bypasses the planner.
TEST(Servo, SetPointIsFartherAndNotFasterAfterMissedTicks) {
  Rig<Slide> rig;
  ASSERT_FALSE(rig.send(joint_command(one(0.75), 1500, 1500)));
  rig.run(750);
  const double before = rig.hardware.velocity_target[0];
  ASSERT_GT(before, 1);
  rig.now += 4;
  rig.tick();
  EXPECT_NEAR(rig.hardware.velocity_target[0], before, 0.01 * before);
}

TEST(Servo, SetPointBeyondALimitStopsTheRobot) {
  Rig<Slide> rig;
  Macrostep wild;
  wild.epoch = rig.seen().epoch;
  wild.ticket = 1;
  wild.steps = wild.reply_step = 10;
  wild.from = rig.seen().desired;
  wild.to = DesiredState::resting_at(one(1.9));
  wild.path.plan_joints(wild.from, wild.to, 10 * kPeriod);
  rig.hand_over.macrosteps.push(wild);
  double previous = rig.seen().desired.position[0];
  for (int i = 0; i < 200; ++i) {
    rig.tick();
    EXPECT_LE(std::abs(rig.seen().desired.position[0] - previous), 0.8 * kPeriod * 1.001);
    previous = rig.seen().desired.position[0];
  }
  EXPECT_EQ(rig.seen().fault.code, ErrorCode::velocity_limit);
  EXPECT_FALSE(rig.hardware.powered);
}

}  // namespace
}  // namespace mrroc::edp::servo_test
