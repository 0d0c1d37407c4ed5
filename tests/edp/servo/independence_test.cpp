// Original's defect 8: static locals in methods of a robot carried state from one robot, and one motion, to another.
#include <gtest/gtest.h>

#include <functional>
#include <vector>

#include "edp/force/force_rig.hpp"

namespace mrroc::edp::independence_test {
namespace {

using Robot = ForceRig<Gantry>;

RobotCommand press() {
  RobotCommand command = force_command(10);
  command.twist[1] = 0.05;
  return command;
}

/// Moves to the wall, presses, leaves it: the next command follows each answer.
void work(Robot& robot, int tick) {
  if (robot.replies.empty() && tick > 0) return;
  robot.replies.clear();
  RobotCommand command = press();
  if (tick > 1500) command = joint_command(JointVector::Zero(4), 600, 600);
  EXPECT_FALSE(robot.send(command)) << robot.answer.state.error.detail.view();
}

std::vector<JointVector> path(const std::function<void(int)>& disturb) {
  Robot robot;
  std::vector<JointVector> set_points;
  for (int i = 0; i < 2500; ++i) {
    work(robot, i);
    disturb(i);
    robot.tick();
    set_points.push_back(robot.seen().desired.position);
  }
  return set_points;
}

// original's defect 8
TEST(Independence, ARobotDoesNotFeelAnotherOneInTheSameProcess) {
  const std::vector<JointVector> alone = path([](int) {});
  EXPECT_GT(alone[1400][0], 0.1) << "it presses";
  Robot other;
  other.sensor.wall = 0.05;
  const std::vector<JointVector> together = path([&other](int i) {
    if (i % 7 == 0) {
      RobotCommand command = force_command(5, 0);
      command.twist[2] = -0.03;
      other.send(command);  // accepted, busy or late: without effect on the first one
    }
    if (i % 3 != 0) other.tick();
  });
  EXPECT_LT(other.seen().desired.position[2], -0.01) << "it moves";
  EXPECT_EQ(together, alone) << "to the last bit";
}

// original's defect 8
TEST(Independence, AMotionDoesNotFeelTheOneBefore) {
  Robot robot;
  robot.sensor.wall = 10;
  const auto way = [&robot](double speed) {
    const JointVector start = robot.seen().desired.position;
    std::vector<JointVector> increments;
    EXPECT_FALSE(robot.send(force_command(0, speed)));
    for (int i = 0; i < 100; ++i) {
      robot.tick();
      increments.push_back(robot.seen().desired.position - start);
    }
    EXPECT_TRUE(robot.seen().desired.at_rest());
    return increments;
  };
  const std::vector<JointVector> first = way(0.05);
  EXPECT_GT(first.back()[0], 1e-4);
  way(-0.3);
  way(0.2);
  const std::vector<JointVector> again = way(0.05);
  for (std::size_t i = 0; i < first.size(); ++i) ASSERT_LT((again[i] - first[i]).norm(), 1e-12) << i;
}

}  // namespace
}  // namespace mrroc::edp::independence_test
