// The operator's motions beside a task, faults and changes.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "edp/command/operated.hpp"

namespace mrroc::edp::operator_and_task_test {
namespace {

/// The task of a pause: holds, one after the other.
void hold_for(
    Operated& robot, int macrosteps, const std::function<void()>& each = [] {}) {
  for (int i = 0; i < macrosteps; ++i) {
    RobotCommand hold = order(CommandKind::hold);
    hold.motion_steps = 10;
    hold.reply_step = 8;
    const std::size_t before = robot.replies.size();
    robot.task_command(hold);
    each();
    for (int tick = 0; tick < 40 && robot.replies.size() == before; ++tick) robot.tick();
    ASSERT_EQ(robot.replies.size(), before + 1) << "every hold is answered";
    EXPECT_EQ(robot.replies.back().state.error.code, ErrorCode::none);
  }
}

/// Wherever in a macrostep of the jog the task's motion comes: it counts as late, the robot comes to rest and holds
/// instead, and the next one is executed.
TEST(OperatorMotion, TaskTakesTheRobotAndHasItUntilItIsIdle) {
  for (int moment = 0; moment < 25; ++moment) {
    Operated robot;
    robot.give(jog(0, 0.3));
    robot.run(static_cast<Tick>(40 + moment));
    const RobotCommand command = joint_command(axis(0, 0.3), 500, 500);
    robot.task_command(command);
    robot.give(jog(0, 0.3));
    EXPECT_EQ(robot.last_error(), ErrorCode::busy);
    robot.run(1000);
    ASSERT_EQ(robot.replies.size(), 1U) << moment;
    EXPECT_EQ(robot.replies[0].state.error.code, ErrorCode::none) << moment;
    EXPECT_EQ(robot.replies[0].state.late_commands, 1U);
    EXPECT_EQ(robot.replies[0].state.tick, robot.replies[0].state.macrostep_start + 500) << moment;
    EXPECT_TRUE(robot.at_rest()) << moment;
    EXPECT_LT(robot.position()[0], 0.1) << moment;
    robot.task_command(command);
    robot.run(1000);
    ASSERT_EQ(robot.replies.size(), 2U) << moment;
    EXPECT_EQ(robot.replies[1].state.error.code, ErrorCode::none);
    EXPECT_EQ(robot.replies[1].state.late_commands, 1U);
    EXPECT_EQ(robot.position()[0], 0.3);
    robot.give(jog(0, -0.3));
    EXPECT_EQ(robot.last_error(), ErrorCode::none);
  }
}

// the macrosteps of a task may be as long as 20 s, and begin later
TEST(OperatorMotion, RobotIsTheTasksUntilItsMacrostepHasEnded) {
  for (const auto& [steps, later] : {std::pair{100, 0}, {500, 0}, {100, 300}}) {
    Operated robot;
    robot.run(10);
    RobotCommand command =
        joint_command(axis(0, 0.05), static_cast<std::uint16_t>(steps), static_cast<std::uint16_t>(steps - 2));
    if (later > 0) command.start_tick = robot.now + static_cast<Tick>(later);
    robot.task_command(command);
    for (int tick = 0; tick < steps + later; tick += 20) {
      robot.give(jog(0, 0.3));
      EXPECT_EQ(robot.last_error(), ErrorCode::busy) << steps << " " << later << " " << tick;
      robot.run(20);
    }
    robot.run(60);
    EXPECT_EQ(robot.position()[0], 0.05);
    robot.give(jog(0, 0.3));
    EXPECT_EQ(robot.last_error(), ErrorCode::none);
  }
}

TEST(OperatorMotion, RobotOfAPausedTaskJogsAndItsHoldsAreAnswered) {
  Operated robot;
  hold_for(robot, 5);
  robot.give(jog(0, 0.3));
  EXPECT_EQ(robot.last_error(), ErrorCode::busy) << "the task is not paused";
  RobotCommand paused = jog(0, 0.3);
  paused.choice = OperatorMotion::kTaskPaused;
  hold_for(robot, 40, [&] { robot.give(paused); });
  EXPECT_EQ(robot.last_error(), ErrorCode::none);
  EXPECT_NEAR(robot.velocity()[0], 0.3, 1e-9);
  EXPECT_FALSE(robot.replies.back().state.at_rest()) << "the task sees that the robot moves";
  hold_for(robot, 40);
  EXPECT_TRUE(robot.replies.back().state.at_rest());
  paused = go(axis(0, 0.1));
  paused.choice = OperatorMotion::kTaskPaused;
  robot.give(paused);
  hold_for(robot, 100);
  EXPECT_EQ(robot.position()[0], 0.1);
  EXPECT_EQ(robot.effector.counters().late, 0U);
  robot.task_command(joint_command(axis(0, 0.3), 500, 500));
  robot.run(1500);
  EXPECT_EQ(robot.replies.back().state.error.code, ErrorCode::none);
  EXPECT_EQ(robot.position()[0], 0.3);
}

RobotCommand motor_jog(int index, double velocity) {
  RobotCommand command = order(CommandKind::motor);
  command.joint_velocity = axis(index, velocity);
  return command;
}

TEST(OperatorMotion, MotorJogMovesTheJointsOfASynchronisedRobot) {
  Operated robot;
  robot.give(motor_jog(1, 10));
  EXPECT_EQ(robot.last_error(), ErrorCode::none);
  robot.run(50);
  EXPECT_NEAR(robot.velocity()[1], 10 / GearedModel::kGear, 1e-9);
}

TEST(OperatorMotion, RobotThatIsNotSynchronisedTakesMotorJogsOnly) {
  Operated robot(false);
  robot.give(go(axis(0, 0.1)));
  EXPECT_EQ(robot.last_error(), ErrorCode::not_synchronised);
  RobotCommand twist = order(CommandKind::twist);
  twist.twist[0] = 0.1;
  robot.give(twist);
  EXPECT_EQ(robot.last_error(), ErrorCode::not_synchronised);
  const double before = robot.position()[1];
  robot.give(motor_jog(1, 3));
  EXPECT_EQ(robot.last_error(), ErrorCode::none);
  robot.run(400);
  EXPECT_GT(robot.position()[1], before);
  EXPECT_TRUE(robot.at_rest());
}

TEST(OperatorMotion, EmergencyStopEndsAJogAndRecoveryAllowsTheNext) {
  Operated robot;
  robot.give(jog(0, 0.3));
  robot.run(50);
  robot.operators.press();
  robot.run(300);
  robot.give(jog(0, 0.3));
  EXPECT_NE(robot.last_error(), ErrorCode::none);
  robot.operators.reset();
  robot.run(5);
  const std::uint64_t number = robot.give(order(CommandKind::recover));
  robot.run(300);
  EXPECT_EQ(robot.answers.back().command, number);
  EXPECT_EQ(robot.last_error(), ErrorCode::none);
  robot.give(jog(0, -0.3));
  robot.run(50);
  EXPECT_LT(robot.velocity()[0], 0);
}

TEST(OperatorMotion, OneOutputChangesAndTheOthersStay) {
  Operated robot;
  RobotCommand set = order(CommandKind::set_outputs);
  set.choice = 3;
  set.outputs.set(3, true);
  robot.give(set);
  robot.run(5);
  set.choice = ControllerIo::kDigital + 2;
  set.outputs = {};
  set.outputs.analog[2] = 1.5;
  robot.give(set);
  robot.run(5);
  const ControllerIo outputs = robot.query().outputs;
  EXPECT_TRUE(outputs.on(3));
  EXPECT_EQ(outputs.analog[2], 1.5);
}

/// Any orders at any time: the limits hold in every tick, every order gets one answer, the robot comes to rest.
TEST(OperatorMotion, RandomOrdersKeepTheLimits) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const auto chance = [&random](double from, double to) {
      return std::uniform_real_distribution<double>(from, to)(random);
    };
    Operated robot;
    for (int i = 0; i < 60; ++i) {
      const int index = static_cast<int>(random() % 4);
      switch (random() % 8) {
        case 0:
        case 1:
        case 2:
          robot.give(jog(index, chance(-1.2, 1.2)));
          break;
        case 3: {
          RobotCommand twist = order(CommandKind::twist);
          twist.relative = random() % 2 == 0;
          twist.twist[static_cast<Eigen::Index>(random() % 3)] = chance(-0.5, 0.5);
          robot.give(twist);
          break;
        }
        case 4:
          robot.give(go(axis(index, chance(-0.6, 0.6))));
          break;
        case 5:
          robot.give(go(axis(index, chance(-0.2, 0.2)), true));
          break;
        case 6:
          robot.give(order(CommandKind::hold));
          break;
        default:
          if (random() % 3 == 0) robot.task_command(joint_command(robot.position(), 50, 40));
          break;
      }
      robot.run(static_cast<Tick>(random() % 120));
    }
    robot.run(5000);
    RC_ASSERT(robot.at_rest());
    RC_ASSERT(robot.seen().fault.code == ErrorCode::none);
    std::vector<std::uint64_t> answered;
    for (const Reply& answer : robot.answers) answered.push_back(answer.command);
    std::sort(answered.begin(), answered.end());
    RC_ASSERT(answered.size() == robot.orders);
    RC_ASSERT(std::adjacent_find(answered.begin(), answered.end()) == answered.end());
    RC_ASSERT(!testing::Test::HasFailure());
  }));
}

}  // namespace
}  // namespace mrroc::edp::operator_and_task_test
