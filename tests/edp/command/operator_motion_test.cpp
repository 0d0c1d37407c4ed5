#include "edp/command/operator_motion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "edp/command/operated.hpp"
#include "geometry/rigid_motion.hpp"

namespace mrroc::edp::operator_motion_test {
namespace {

/// Ticks from 0.5 m/s to rest under the limits of the axes.
Tick braking_ticks(double velocity) {
  const AxisParameters axis = Gantry().parameters().axes[0];
  AxisStop stop;
  stop.plan(0, velocity, 0, axis.acceleration_max, axis.jerk_max);
  return static_cast<Tick>(std::ceil(stop.duration() / kPeriod)) + 1;
}

TEST(OperatorMotion, JogMovesAtOnceAndStopsWhenNoOtherComes) {
  Operated robot;
  const Tick begin = robot.seen().tick;
  robot.give(jog(0, 0.5));
  EXPECT_EQ(robot.answers.size(), 1U);
  EXPECT_EQ(robot.last_error(), ErrorCode::none);
  robot.run(OperatorMotion::kSteps);
  EXPECT_GT(robot.velocity()[0], 0) << "within a macrostep";
  while (robot.seen().tick < begin + kValid) {
    robot.tick();
    EXPECT_GT(robot.velocity()[0], 0);
  }
  robot.run(braking_ticks(0.5));
  EXPECT_TRUE(robot.at_rest()) << "the validity and the braking time have passed";
  EXPECT_EQ(robot.effector.counters().late, 0U);
}

TEST(OperatorMotion, RepeatedJogKeepsItsVelocityAndTakesANewOne) {
  Operated robot;
  for (int i = 0; i < 10; ++i) {
    robot.give(jog(0, 0.2));
    robot.run(25);
    if (i > 3) {
      EXPECT_NEAR(robot.velocity()[0], 0.2, 1e-9);
    }
  }
  robot.give(jog(1, -0.1));
  robot.run(80);
  EXPECT_NEAR(robot.velocity()[0], 0, 1e-9);
  EXPECT_NEAR(robot.velocity()[1], -0.1, 1e-9);
  robot.give(order(CommandKind::hold));
  robot.run(40);
  EXPECT_TRUE(robot.at_rest());
}

TEST(OperatorMotion, JogEndsBeforeALimitAndLeavesIt) {
  Operated robot;
  const double limit = robot.model.parameters().axes[0].position_max;
  for (int i = 0; i < 400; ++i) {
    robot.give(jog(0, 0.5));
    robot.run(20);
  }
  EXPECT_TRUE(robot.at_rest());
  EXPECT_NEAR(robot.position()[0], limit, 0.01);
  EXPECT_NE(robot.last_error(), ErrorCode::none) << "there it goes no farther";
  robot.give(jog(0, -0.5));
  EXPECT_EQ(robot.last_error(), ErrorCode::none);
  robot.run(50);
  EXPECT_LT(robot.velocity()[0], 0);
}

TEST(OperatorMotion, TravelReachesItsGoalExactly) {
  Operated robot;
  JointVector goal(4);
  goal << 0.4, -0.2, 0.1, 0.7;
  const std::uint64_t number = robot.give(go(goal));
  EXPECT_TRUE(robot.answers.empty());
  for (Tick i = 0; robot.answers.empty() && i < 5000; ++i) robot.tick();
  ASSERT_EQ(robot.answers.size(), 1U);
  EXPECT_EQ(robot.answers[0].command, number);
  EXPECT_EQ(robot.last_error(), ErrorCode::none);
  EXPECT_EQ(robot.position(), goal);
  EXPECT_TRUE(robot.at_rest());
  EXPECT_EQ(robot.effector.counters().late, 0U);
  robot.give(go(goal));
  robot.run(50);
  EXPECT_EQ(robot.answers.size(), 2U) << "it is there";
  robot.give(go(axis(2, -0.05), true));
  robot.run(1000);
  EXPECT_NEAR(robot.position()[2], 0.05, 1e-12);
}

TEST(OperatorMotion, ToolStepIsInToolAxesAndBaseStepInBaseAxes) {
  Operated robot;
  robot.give(go(axis(3, 1.0)));
  robot.run(3000);
  RobotCommand step = order(CommandKind::pose);
  step.relative = true;
  step.interpolation = Interpolation::task;
  step.pose.translation().x() = 0.1;
  robot.give(step);
  robot.run(1000);
  EXPECT_NEAR(robot.position()[0], 0.1 * std::cos(1.0), 1e-9);
  EXPECT_NEAR(robot.position()[1], 0.1 * std::sin(1.0), 1e-9);
  step.pose = Pose::Identity();
  step.twist << -0.1, 0, 0, 0, 0, -0.5;
  robot.give(step);
  robot.run(2000);
  EXPECT_NEAR(robot.position()[0], 0.1 * std::cos(1.0) - 0.1, 1e-9);
  EXPECT_NEAR(robot.position()[1], 0.1 * std::sin(1.0), 1e-9);
  EXPECT_NEAR(robot.position()[3], 0.5, 1e-9);
  for (const Reply& answer : robot.answers) EXPECT_EQ(answer.state.error.code, ErrorCode::none);
}

TEST(OperatorMotion, GoalBeyondALimitIsRefusedBeforeTheRobotMoves) {
  Operated robot;
  robot.give(go(axis(0, 100)));
  EXPECT_EQ(robot.last_error(), ErrorCode::joint_limit);
  robot.give(go(axis(0, std::nan(""))));
  EXPECT_EQ(robot.last_error(), ErrorCode::not_finite);
  robot.give(jog(0, std::nan("")));
  EXPECT_EQ(robot.last_error(), ErrorCode::not_finite);
  robot.run(100);
  EXPECT_EQ(robot.answers.size(), 3U);
  EXPECT_EQ(robot.position()[0], 0);
}

TEST(OperatorMotion, HoldEndsATravelAndAnswersIt) {
  Operated robot;
  const std::uint64_t number = robot.give(go(axis(0, 0.4)));
  robot.run(60);
  EXPECT_GT(robot.velocity()[0], 0);
  robot.give(jog(0, 0.1));
  EXPECT_EQ(robot.last_error(), ErrorCode::busy);
  robot.give(order(CommandKind::hold));
  robot.run(2 * OperatorMotion::kSteps + braking_ticks(1));
  EXPECT_TRUE(robot.at_rest());
  EXPECT_EQ(robot.answers.back().command, number);
  EXPECT_EQ(robot.last_error(), ErrorCode::busy);
  robot.give(go(axis(0, 0.4)));
  robot.run(2000);
  EXPECT_EQ(robot.position()[0], 0.4);
}

/// At every moment of the braking.
TEST(OperatorMotion, TravelThatComesWhileTheRobotBrakesBeginsAtRest) {
  for (Tick after = 0; after < braking_ticks(1) + 10; ++after) {
    SCOPED_TRACE(after);
    Operated robot;
    robot.give(jog(0, 0.5));
    robot.run(60);
    EXPECT_GT(robot.velocity()[0], 0);
    robot.give(order(CommandKind::hold));
    robot.run(after);
    const std::uint64_t number = robot.give(go(axis(0, -0.05), true));
    double farthest = robot.position()[0];
    for (Tick i = 0; i < 2000 && robot.answers.back().command != number; ++i) {
      robot.tick();
      farthest = std::max(farthest, robot.position()[0]);
    }
    EXPECT_EQ(robot.answers.back().command, number);
    EXPECT_EQ(robot.last_error(), ErrorCode::none);
    EXPECT_TRUE(robot.at_rest());
    EXPECT_NEAR(robot.position()[0], farthest - 0.05, 1e-9);
    EXPECT_EQ(robot.effector.counters().late, 0U);
  }
}

TEST(OperatorMotion, WhatWaitsForRestIsEndedByHoldByATaskAndRefusedBeyondALimit) {
  enum class Ended { by_hold, by_task, by_limit };
  for (const Ended ended : {Ended::by_hold, Ended::by_task, Ended::by_limit}) {
    SCOPED_TRACE(static_cast<int>(ended));
    Operated robot;
    robot.give(go(axis(0, 0.4)));
    robot.run(60);
    robot.give(order(CommandKind::hold));
    robot.run(5);
    EXPECT_GT(robot.velocity()[0], 0);
    const std::uint64_t number = robot.give(go(axis(0, ended == Ended::by_limit ? 100 : 0.3)));
    robot.give(go(axis(0, 0.2)));
    EXPECT_EQ(robot.last_error(), ErrorCode::busy) << "one waits already";
    if (ended == Ended::by_hold) robot.give(order(CommandKind::hold));
    if (ended == Ended::by_task) robot.task_command(order(CommandKind::query));
    robot.run(1000);
    const auto answer = std::find_if(robot.answers.begin(), robot.answers.end(),
                                     [&](const Reply& reply) { return reply.command == number; });
    ASSERT_NE(answer, robot.answers.end());
    EXPECT_EQ(answer->state.error.code, ended == Ended::by_limit ? ErrorCode::joint_limit : ErrorCode::busy);
    EXPECT_TRUE(robot.at_rest());
    EXPECT_LT(robot.position()[0], 0.2);
  }
}

}  // namespace
}  // namespace mrroc::edp::operator_motion_test
