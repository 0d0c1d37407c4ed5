// Force limits: the servo, the comms side and a wall.
#include <gtest/gtest.h>

#include "force_rig.hpp"

namespace mrroc::edp::force_limit_test {
namespace {

TEST(ForceLimit, StopsAnyMotionAndLetsTheRobotOut) {
  GantryBeforeWall rig;
  const RobotState hit = rig.exchange(joint_command((JointVector(4) << 0.4, 0, 0, 0).finished(), 500, 500));
  EXPECT_EQ(hit.error.code, ErrorCode::force_limit);
  EXPECT_EQ(hit.error.error_class, ErrorClass::non_fatal);
  EXPECT_NE(hit.error.detail.view().find("axis 1"), std::string_view::npos) << hit.error.detail.view();
  rig.run(500);
  const JointVector there = rig.seen().desired.position;
  EXPECT_GT(std::abs(rig.sensor.read(0, nullptr).wrench[0] + rig.seen().wrench[0]), 65);
  EXPECT_EQ(rig.exchange(joint_command(there + 0.1 * JointVector::Unit(4, 0), 500, 500)).error.code,
            ErrorCode::force_limit)
      << "no farther in";
  EXPECT_TRUE(well(rig.exchange(joint_command(JointVector::Zero(4), 1000, 1000)))) << "but out";
  EXPECT_EQ(rig.exchange(joint_command((JointVector(4) << 0.4, 0, 0, 0).finished(), 500, 500)).error.code,
            ErrorCode::force_limit)
      << "and monitored as before";
}

/// An arm that follows its set-point late presses harder after the set-point has begun to leave.
TEST(ForceLimit, ForceThatGrowsWhileTheSetPointLeavesDoesNotStopIt) {
  const JointVector in = (JointVector(4) << 0.4, 0, 0, 0).finished(), out = JointVector::Zero(4);
  const JointVector deeper = (JointVector(4) << 0.4, 0.1, 0, 0).finished();
  for (const double growth : {5.0, 20.0, 80.0}) {
    for (const bool leaves : {true, false}) {
      SCOPED_TRACE(testing::Message() << growth << (leaves ? " out" : " in"));
      GantryBeforeWall rig;
      ASSERT_EQ(rig.exchange(joint_command(in, 500, 500)).error.code, ErrorCode::force_limit);
      rig.run(500);
      rig.replies.clear();
      ASSERT_FALSE(rig.send(joint_command(leaves ? out : deeper, 1000, 1000)));
      rig.run(2);
      rig.sensor.extra[0] = -growth;
      rig.run(30);
      rig.sensor.extra[0] = 0;
      for (int i = 0; i < 2000 && rig.replies.empty(); ++i) rig.tick();
      ASSERT_EQ(rig.replies.size(), 1U);
      EXPECT_EQ(rig.replies[0].state.error.code, leaves ? ErrorCode::none : ErrorCode::force_limit);
    }
  }
}

/// A command that comes late stops a robot on its way out, and the next one leads it back to its path.
TEST(ForceLimit, RestsOnTheWayOutAllowTheWayBackToTheFirst) {
  GantryBeforeWall rig;
  rig.sensor.stiffness = 10000;
  const auto go = [&rig](double x) {
    return rig.exchange(joint_command((JointVector(4) << x, 0, 0, 0).finished(), 1000, 1000)).error.code;
  };
  ASSERT_EQ(go(0.4), ErrorCode::force_limit);
  rig.run(500);
  const double there = rig.seen().desired.position[0];
  const double limit = rig.sensor.wall + 65 / rig.sensor.stiffness;
  ASSERT_GT(there - limit, 0.3 * 65 / rig.sensor.stiffness) << "the return would add less than a tenth";
  const double out = there - 0.8 * (there - limit);
  EXPECT_EQ(go(out), ErrorCode::none);
  rig.run(500);
  EXPECT_EQ(go(there - 1e-6), ErrorCode::none);
  rig.run(500);
  EXPECT_EQ(go(out), ErrorCode::none);
  rig.run(500);
  EXPECT_EQ(go(there + 0.1), ErrorCode::force_limit);
}

/// Only an axis beyond its limit may meet more force.
TEST(ForceLimit, AnotherObstacleStopsARobotThatLeaves) {
  GantryBeforeWall rig;
  ASSERT_EQ(rig.exchange(joint_command((JointVector(4) << 0.4, 0, 0, 0).finished(), 500, 500)).error.code,
            ErrorCode::force_limit);
  rig.run(500);
  rig.replies.clear();
  ASSERT_FALSE(rig.send(joint_command(JointVector::Zero(4), 1000, 1000)));
  rig.run(2);
  rig.sensor.extra[1] = -66;
  for (int i = 0; i < 2000 && rig.replies.empty(); ++i) rig.tick();
  ASSERT_EQ(rig.replies.size(), 1U);
  EXPECT_EQ(rig.replies[0].state.error.code, ErrorCode::force_limit);
}

TEST(ForceLimit, InterruptionAfterTheReplyAnswersTheNextCommand) {
  GantryBeforeWall rig;
  ASSERT_TRUE(well(rig.exchange(joint_command((JointVector(4) << 0.4, 0, 0, 0).finished(), 500, 1))));
  rig.run(700);
  const RobotState state = rig.exchange(joint_command(JointVector::Zero(4), 1000, 1000));
  EXPECT_EQ(state.error.code, ErrorCode::force_limit);
  EXPECT_TRUE(well(rig.exchange(joint_command(JointVector::Zero(4), 1000, 1000)))) << "reported once";
}

TEST(ForceLimit, CommandBehindTheInterruptedOneIsNotExecuted) {
  GantryBeforeWall rig;
  ASSERT_FALSE(rig.send(joint_command((JointVector(4) << 0.4, 0, 0, 0).finished(), 500, 500)));
  rig.run(20);
  ASSERT_FALSE(rig.send(joint_command((JointVector(4) << 0, 0.2, 0, 0).finished(), 1000, 1000)));
  rig.run(2000);
  ASSERT_EQ(rig.replies.size(), 2u);
  for (const Reply& reply : rig.replies) EXPECT_EQ(reply.state.error.code, ErrorCode::force_limit);
  EXPECT_NEAR(rig.seen().desired.position[1], 0, 1e-9) << "its sender had no report of the wall";
  EXPECT_TRUE(well(rig.exchange(joint_command(JointVector::Zero(4), 1000, 1000)))) << "reported by now";
}

TEST(ForceLimit, RefusedOutputsDoNotHideAnInterruption) {
  GantryBeforeWall rig;
  ASSERT_TRUE(well(rig.exchange(joint_command((JointVector(4) << 0.4, 0, 0, 0).finished(), 500, 1))));
  rig.run(700);
  RobotCommand outputs;
  outputs.kind = CommandKind::set_outputs;
  outputs.outputs.analog[0] = std::nan("");
  EXPECT_EQ(rig.exchange(outputs).error.code, ErrorCode::not_finite);
  EXPECT_EQ(rig.exchange(joint_command(JointVector::Zero(4), 1000, 1000)).error.code, ErrorCode::force_limit);
}

/// Each of its macrosteps adds less than a tenth to the force that the one before has left.
TEST(ForceLimit, StopsAMotionOfManyMacrosteps) {
  for (const bool stops_between : {false, true}) {
    GantryBeforeWall rig;
    double most = 0;
    RobotState state;
    for (int i = 0; i < 2000 && well(state); ++i) {
      RobotCommand command = joint_command((JointVector(4) << 0.0003, 0, 0, 0).finished(), 10, 8);
      command.relative = true;
      if (!stops_between) command.joint_velocity = (JointVector(4) << 0.015, 0, 0, 0).finished();
      state = rig.exchange(command);
      most = std::max(most, std::abs(rig.seen().wrench[0]));
    }
    EXPECT_EQ(state.error.code, ErrorCode::force_limit) << stops_between;
    EXPECT_LT(most, 66) << stops_between;
  }
}

TEST(ForceLimit, RobotAtRestIsNotDisturbed) {
  GantryBeforeWall rig;
  rig.sensor.extra[2] = 500;
  rig.run(100);
  EXPECT_TRUE(well(rig.query()));
  EXPECT_EQ(rig.query().wrench[2], 500);
}

TEST(ForceLimit, BiasRemovesThePresentWrench) {
  GantryBeforeWall rig;
  rig.sensor.extra[2] = 60;
  RobotCommand bias;
  bias.kind = CommandKind::bias_force;
  const RobotState state = rig.exchange(bias);
  ASSERT_TRUE(well(state));
  EXPECT_EQ(state.wrench[2], 0) << "from that very tick on";
  Rig<Gantry> blind;
  ASSERT_TRUE(blind.send(bias));
  EXPECT_EQ(blind.answer.state.error.code, ErrorCode::invalid_argument);
}

TEST(ForceLimit, LearnsTheLoadInTheSensorFrame) {
  GantryBeforeWall rig;
  RobotCommand tool;
  tool.kind = CommandKind::set_tool;
  tool.pose = Pose(Eigen::Translation3d(0, 0, 0.2));
  ASSERT_TRUE(well(rig.exchange(tool)));
  RobotCommand carry;
  carry.kind = CommandKind::carry;
  carry.load = {1.5, {0.01, 0.02, 0.05}};
  ASSERT_TRUE(well(rig.exchange(carry)));
  EXPECT_EQ(rig.sensor.carried.mass, 1.5);
  EXPECT_TRUE(rig.sensor.carried.centre.isApprox(Eigen::Vector3d(0.01, 0.02, 0.25))) << "given in the tool frame";
}

TEST(ForceLimit, ImpossibleLoadsAreRefused) {
  GantryBeforeWall rig;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Load& load : {Load{-1, Eigen::Vector3d::Zero()}, Load{nan, Eigen::Vector3d::Zero()},
                           Load{2000, Eigen::Vector3d::Zero()}, Load{1, {0, 0, 11}}, Load{1, {nan, 0, 0}}}) {
    RobotCommand carry;
    carry.kind = CommandKind::carry;
    carry.load = load;
    EXPECT_EQ(rig.exchange(carry).error.code, ErrorCode::invalid_argument) << load.mass;
    EXPECT_EQ(rig.sensor.carried.mass, 0);
  }
  RobotCommand carry;
  carry.kind = CommandKind::carry;
  Rig<Gantry> blind;
  ASSERT_TRUE(blind.send(carry));
  EXPECT_EQ(blind.answer.state.error.code, ErrorCode::invalid_argument);
}

}  // namespace
}  // namespace mrroc::edp::force_limit_test
