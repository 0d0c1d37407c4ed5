#include "edp/command/effector.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <utility>

#include "edp/command/cruise.hpp"

namespace mrroc::edp::effector_test {
namespace {

TEST(Effector, AnswersAQueryAtOnceWithoutAChange) {
  Rig<Slide> rig;
  ASSERT_TRUE(rig.send(RobotCommand{}));
  EXPECT_EQ(rig.answer.command, 1u);
  EXPECT_EQ(rig.answer.state.tick, 0u);
  EXPECT_EQ(rig.answer.state.desired_tick, 0u);
  EXPECT_NEAR(rig.answer.state.desired_pose.translation().x(), 0.25, 1e-4);
  EXPECT_EQ(rig.effector.counters().accepted, 0u);
}

// original's defect 1: the error of a command came with the reply to the next one
TEST(Effector, TheReplyToABadCommandIsTheErrorItself) {
  Rig<Slide> rig;
  ASSERT_TRUE(rig.send(joint_command(one(5), 100, 50)));
  EXPECT_EQ(rig.answer.command, 1u);
  EXPECT_EQ(rig.answer.state.error.error_class, ErrorClass::non_fatal);
  EXPECT_EQ(rig.answer.state.error.code, ErrorCode::joint_limit);
  EXPECT_EQ(rig.effector.counters().refused, 1u);
  EXPECT_FALSE(rig.send(joint_command(one(0.3), 100, 50)));
  rig.run(50);
  ASSERT_EQ(rig.replies.size(), 1u);
  EXPECT_EQ(rig.replies[0].command, 2u);
  EXPECT_EQ(rig.replies[0].state.error.code, ErrorCode::none);
}

// original's defect 5: a v out of range never released the caller
TEST(Effector, TheReplyLeavesAtTickVExactly) {
  for (const std::uint16_t v : std::initializer_list<std::uint16_t>{1, 7, 99, 100, 101}) {
    Rig<Slide> rig;
    ASSERT_FALSE(rig.send(joint_command(one(0.27), 100, v)));
    rig.run(v - 1u);
    EXPECT_TRUE(rig.replies.empty()) << v;
    rig.run(1);
    ASSERT_EQ(rig.replies.size(), 1u) << v;
    const RobotState& state = rig.replies[0].state;
    EXPECT_EQ(state.tick, v);
    EXPECT_EQ(state.macrostep_start, 0u);
    EXPECT_EQ(state.desired_tick, std::max<Tick>(100, v));
    EXPECT_EQ(state.desired_joints[0], 0.27);
    EXPECT_EQ(state.joints[0], rig.seen().joints[0]);
    rig.run(200);
    EXPECT_EQ(rig.replies.size(), 1u) << v;
  }
}

TEST(Effector, SuccessorInTimeContinuesWithoutAGap) {
  for (const Tick delay : {0, 1, 2}) {  // v = 198: until tick 200, whose set-point is the common boundary
    Rig<Slide> rig;
    run_up(rig);
    rig.run(delay);
    ASSERT_FALSE(rig.send(cruise(0.42, 20, 20)));
    double previous = rig.seen().desired.position[0];
    for (Tick i = delay; i < 22; ++i) {
      rig.tick();
      const double now = rig.seen().desired.position[0];
      if (rig.seen().tick > 200) {
        EXPECT_NEAR((now - previous) / kPeriod, 0.5, 1e-9) << rig.seen().tick;
      }
      previous = now;
    }
    EXPECT_EQ(rig.seen().desired.position[0], 0.42);
    EXPECT_EQ(rig.effector.counters().late, 0u);
    ASSERT_EQ(rig.replies.size(), 1u);
    EXPECT_EQ(rig.replies[0].state.tick, 220u);
  }
}

// original's defect 2: a late command silently became zero velocity within one step
TEST(Effector, WithoutASuccessorItBrakesWithinItsLimitsAndHolds) {
  Rig<Slide> rig;
  run_up(rig);
  double p = rig.seen().desired.position[0], v = rig.seen().desired.velocity[0], a = rig.seen().desired.acceleration[0];
  int ticks_of_motion = 0;
  for (int i = 0; i < 500; ++i) {
    rig.tick();
    const DesiredState& desired = rig.seen().desired;
    if (rig.seen().tick > 200) {
      EXPECT_LE(std::abs(desired.acceleration[0]), 8 + 1e-9);
      EXPECT_LE(std::abs(desired.acceleration[0] - a), 4000 * kPeriod + 1e-9);
      EXPECT_NEAR((desired.position[0] - p) / kPeriod, 0.5 * (v + desired.velocity[0]), 2e-3);
      ticks_of_motion += desired.velocity[0] != 0;
    }
    p = desired.position[0], v = desired.velocity[0], a = desired.acceleration[0];
  }
  EXPECT_EQ(v, 0);
  // 0.5 rad/s at 8 rad/s^2 and 4000 rad/s^3: 0.0645 s
  EXPECT_NEAR(ticks_of_motion, 32, 1);
  EXPECT_NEAR(p, 0.4 + 0.5 * 0.0645 / 2, 1e-9);
  EXPECT_NEAR(rig.seen().joints[0], p, 1e-4);
  EXPECT_EQ(rig.seen().counters.stops, 1u);
}

TEST(Effector, ALateCommandIsCountedAndPlannedFromTheEndOfTheStop) {
  Rig<Slide> rig;
  run_up(rig);
  rig.run(10);  // 8 ticks too late
  EXPECT_EQ(rig.seen().tick, 208u);
  ASSERT_FALSE(rig.send(cruise(0.42, 20, 18)));
  EXPECT_EQ(rig.effector.counters().late, 1u);
  EXPECT_EQ(rig.effector.counters().stretched, 1u);
  DesiredState previous = rig.seen().desired;
  while (rig.replies.empty()) {
    rig.tick();
    const DesiredState& desired = rig.seen().desired;
    EXPECT_LE(std::abs(desired.velocity[0]), 0.8);
    EXPECT_LE(std::abs(desired.position[0] - previous.position[0]), 0.8 * kPeriod);
    EXPECT_LE(std::abs(desired.acceleration[0]), 8 + 1e-9);
    previous = desired;
  }
  EXPECT_EQ(rig.replies[0].state.late_commands, 1u);
  EXPECT_EQ(rig.replies[0].state.desired_joints[0], 0.42);
  EXPECT_EQ(rig.replies[0].state.desired_velocity[0], 0.5);
  // its successor is in time again
  while (rig.seen().tick + 2 < rig.replies[0].state.desired_tick) rig.tick();
  ASSERT_FALSE(rig.send(cruise(0.44, 20, 18)));
  rig.run(10);
  EXPECT_NEAR(rig.seen().desired.velocity[0], 0.5, 1e-9);
  EXPECT_EQ(rig.effector.counters().late, 1u);
}

TEST(Effector, CommandAfterTheReportedStopIsNotLate) {
  Rig<Slide> rig;
  run_up(rig);
  rig.run(10);
  const RobotState state = rig.query();
  EXPECT_GT(state.desired_tick, state.tick);
  EXPECT_EQ(state.desired_velocity[0], 0);
  RobotCommand command = joint_command(one(0.05), 300, 300);
  command.relative = true;
  ASSERT_FALSE(rig.send(command));
  rig.run(600);
  EXPECT_EQ(rig.effector.counters().late, 0u);
  EXPECT_NEAR(rig.seen().desired.position[0], state.desired_joints[0] + 0.05, 1e-15);
}

// real time: the comms side runs only after the robot has begun to brake
TEST(Effector, ReplyFromBeforeTheStopDoesNotReportIt) {
  Rig<Slide> rig;
  ASSERT_FALSE(rig.send(cruise(0.4, 200, 198)));
  while (rig.now < 210) rig.servo.tick(rig.now++);
  Reply reply;
  ASSERT_TRUE(rig.effector.poll(reply));
  EXPECT_EQ(reply.state.tick, 198u);
  EXPECT_EQ(reply.state.desired_velocity[0], 0.5);
  ASSERT_FALSE(rig.send(cruise(0.42, 20, 18)));
  EXPECT_EQ(rig.effector.counters().late, 1u);
}

TEST(Effector, OneCommandRunsOneWaitsAThirdIsRefused) {
  Rig<Slide> rig;
  EXPECT_FALSE(rig.send(joint_command(one(0.30), 100, 100)));
  EXPECT_FALSE(rig.send(joint_command(one(0.35), 100, 100)));
  ASSERT_TRUE(rig.send(joint_command(one(0.40), 100, 100)));
  EXPECT_EQ(rig.answer.state.error.code, ErrorCode::busy);
  EXPECT_EQ(rig.answer.state.desired_joints[0], 0.35);
  EXPECT_EQ(rig.answer.state.desired_tick, 200u);
  rig.run(100);
  EXPECT_FALSE(rig.send(joint_command(one(0.40), 100, 100)));
  rig.run(300);
  ASSERT_EQ(rig.replies.size(), 3u);
  EXPECT_EQ(rig.replies[0].state.tick, 100u);
  EXPECT_EQ(rig.replies[1].state.tick, 200u);
  EXPECT_EQ(rig.replies[2].state.tick, 300u);
  EXPECT_EQ(rig.seen().desired.position[0], 0.40);
}

// original's defect 6: increments on the measured frame drift
TEST(Effector, AThousandRelativeStepsForthAndBackReturnExactly) {
  for (const bool as_pose : {false, true}) {
    Rig<Gantry> rig;
    const JointVector start = rig.seen().desired.position;
    JointVector increment(4);
    increment << 1e-4, -1.1e-4, 0.9e-4, 1.3e-4;
    for (int i = 0; i < 2000; ++i) {
      RobotCommand command = joint_command(i < 1000 ? increment : JointVector(-increment), 20, 20);
      command.relative = true;
      if (as_pose) {
        command.kind = CommandKind::pose;
        command.pose = rig.model.flange(increment);
        if (i >= 1000) command.pose = command.pose.inverse();
      }
      ASSERT_FALSE(rig.send(command)) << rig.answer.state.error.detail.view();
      rig.run(20);
    }
    EXPECT_EQ(rig.replies.size(), 2000u);
    EXPECT_LT((rig.seen().desired.position - start).norm(), 1e-12);
    EXPECT_LT((rig.seen().joints - start).norm(), 5e-4);
  }
}

// original's defect 21: the counter of steps ended a motion after 131 s
TEST(Effector, AMotionOfManyMacrostepsHasNoLongestDuration) {
  Rig<Slide> rig;
  const double start = rig.seen().desired.position[0];
  const double speed = 1e-3;
  for (int i = 1; i <= 10; ++i) {
    RobotCommand command = joint_command(one(start + speed * i * 20), 10000, 9999);
    command.joint_velocity = one(i < 10 ? speed : 0);
    ASSERT_FALSE(rig.send(command)) << rig.answer.state.error.detail.view();
    rig.run(i == 1 ? 9999 : 10000);
  }
  rig.run(1);
  EXPECT_EQ(rig.seen().tick, 100000u);  // 200 s
  EXPECT_EQ(rig.seen().desired.position[0], start + 0.2);
  EXPECT_EQ(rig.replies.size(), 10u);
  EXPECT_EQ(rig.effector.counters().late, 0u);
}

/// Real time: the servo moves on between the planning and the hand-over.
TEST(Effector, MacrostepOfAnOldEpochIsRefusedAndPlannedAgain) {
  Rig<Slide> rig;
  run_up(rig);
  rig.run(2);
  ASSERT_FALSE(rig.send(cruise(0.42, 20, 20)));
  // as if the servo had ticked before the hand-over: take the macrostep away, tick, put it back
  Macrostep planned = *rig.hand_over.macrosteps.front();
  rig.hand_over.macrosteps.pop();
  rig.tick();
  ASSERT_GT(rig.seen().epoch, planned.epoch);
  rig.hand_over.macrosteps.push(planned);
  rig.run(1);
  EXPECT_EQ(rig.effector.counters().late, 1u);
  rig.run(600);
  ASSERT_EQ(rig.replies.size(), 1u);
  EXPECT_EQ(rig.replies[0].state.error.code, ErrorCode::none);
  EXPECT_EQ(rig.replies[0].state.desired_joints[0], 0.42);
}

}  // namespace
}  // namespace mrroc::edp::effector_test
