// Force motions: the servo, the comms side and a wall.
#include <gtest/gtest.h>

#include "force_rig.hpp"

namespace mrroc::edp::force_test {
namespace {

TEST(ForceMotion, PressesWithTheDesiredForceWhileSliding) {
  GantryBeforeWall rig;
  RobotCommand command = force_command(10);
  command.twist[1] = 0.05;
  const RobotState state = rig.repeat(command, 200);
  ASSERT_TRUE(well(state)) << state.error.detail.view();
  EXPECT_NEAR(state.wrench[0], -10, 0.1);
  EXPECT_NEAR(state.joints[0], 0.11, 2e-4);
  EXPECT_NEAR(rig.seen().desired.velocity[1], 0.05, 1e-9);
  EXPECT_EQ(state.late_commands, 0u);
  EXPECT_EQ(rig.seen().counters.stops, 0u) << "one motion, not two hundred";
}

TEST(ForceMotion, GuardedAxisMovesUntilTheForceBalancesItsVelocity) {
  GantryBeforeWall rig;
  const RobotState state = rig.repeat(force_command(0, 0.05), 400);
  ASSERT_TRUE(well(state)) << state.error.detail.view();
  EXPECT_NEAR(state.wrench[0], -0.05 / 0.01, 0.1) << "v = b F";
}

TEST(ForceMotion, RobotBrakesWithoutASuccessorAndTheNextCommandIsLate) {
  GantryBeforeWall rig;
  ASSERT_TRUE(well(rig.repeat(force_command(0, 0.05), 20)));
  rig.run(200);
  EXPECT_TRUE(rig.seen().desired.at_rest());
  const RobotState state = rig.repeat(force_command(0, 0.05), 2);
  EXPECT_EQ(state.late_commands, 1u);
}

TEST(ForceMotion, OtherCommandIsPlannedFromTheStopAfterIt) {
  for (const CommandKind kind : {CommandKind::hold, CommandKind::joint, CommandKind::pose}) {
    GantryBeforeWall rig;
    RobotCommand command = force_command(10);
    command.twist[1] = 0.05;
    ASSERT_TRUE(well(rig.repeat(command, 100)));
    RobotCommand next = joint_command(JointVector::Zero(4), 10, 10);  // far too fast for ten ticks
    next.kind = kind;
    const RobotState state = rig.exchange(next);
    ASSERT_TRUE(well(state)) << state.error.detail.view();
    EXPECT_EQ(state.late_commands, 0u);
    rig.run(2000);
    EXPECT_TRUE(rig.seen().desired.at_rest());
    if (kind != CommandKind::hold) {
      EXPECT_LT(rig.seen().desired.position.norm(), 1e-9);
    }
  }
}

TEST(ForceMotion, StartsWithThePresentMotionOfTheTool) {
  GantryBeforeWall rig;
  RobotCommand moving;
  moving.kind = CommandKind::joint_velocity;
  moving.joint_velocity = (JointVector(4) << 0, 0.05, 0, 0).finished();
  moving.motion_steps = moving.reply_step = 100;
  ASSERT_TRUE(well(rig.exchange(moving)));
  RobotCommand command = force_command(10);
  command.force.guarded(1);
  command.twist[1] = 0.05;
  ASSERT_FALSE(rig.send(command));
  for (int i = 0; i < 10; ++i) {
    rig.tick();
    EXPECT_NEAR(rig.seen().desired.velocity[1], 0.05, 1e-9);
  }
}

TEST(ForceMotion, LawThatIsTooFastIsScaledAsAWhole) {
  GantryBeforeWall rig;
  rig.sensor.wall = 10;
  RobotCommand command = force_command(0, 40);  // of 0.8 m/s
  command.force.behaviour[0] = AxisBehaviour::unguarded;
  command.twist[1] = 20;
  ASSERT_TRUE(well(rig.repeat(command, 60)));
  EXPECT_NEAR(rig.seen().desired.velocity[0], 0.8 * ForceMotion::kFraction, 1e-6);
  EXPECT_NEAR(rig.seen().desired.velocity[1], 0.4 * ForceMotion::kFraction, 1e-6);
}

TEST(ForceMotion, StopsBeforeAPositionLimitWithANonFatalError) {
  GantryBeforeWall rig;
  rig.sensor.wall = 10;
  const RobotState state = rig.repeat(force_command(0, 0.7), 1000);
  EXPECT_EQ(state.error.code, ErrorCode::joint_limit);
  EXPECT_EQ(state.error.error_class, ErrorClass::non_fatal);
  rig.run(500);
  EXPECT_TRUE(rig.seen().desired.at_rest());
  EXPECT_LE(rig.seen().desired.position[0], 2);
  EXPECT_GT(rig.seen().desired.position[0], 1.9);
  EXPECT_TRUE(well(rig.exchange(joint_command(JointVector::Zero(4), 3000, 3000))));
}

TEST(ForceMotion, WantsASensorAndSaneValues) {
  Rig<Gantry> blind;
  ASSERT_TRUE(blind.send(force_command(10)));
  EXPECT_EQ(blind.answer.state.error.code, ErrorCode::invalid_argument);
  GantryBeforeWall rig;
  RobotCommand command = force_command(10);
  command.force.wrench[0] = std::nan("");
  EXPECT_EQ(rig.exchange(command).error.code, ErrorCode::not_finite);
  command = force_command(10);
  command.reply_step = 12;
  EXPECT_EQ(rig.exchange(command).error.code, ErrorCode::invalid_reply_step);
}

TEST(ForceMotion, ASensorThatFailsInterruptsIt) {
  for (const ErrorCode error :
       {ErrorCode::sensor_hardware, ErrorCode::sensor_not_ready, ErrorCode::sensor_out_of_range}) {
    GantryBeforeWall rig;
    ASSERT_TRUE(well(rig.repeat(force_command(0, 0.05), 20)));
    rig.sensor.error = error;
    EXPECT_EQ(rig.repeat(force_command(0, 0.05), 5).error.code, error);
    rig.run(200);
    EXPECT_TRUE(rig.seen().desired.at_rest());
    EXPECT_EQ(rig.seen().fault.code, ErrorCode::none) << "not a hardware fault of the robot";
  }
}

TEST(ForceMotion, LawUsesTheCurrentToolFrame) {
  GantryBeforeWall rig;
  RobotCommand tool;
  tool.kind = CommandKind::set_tool;
  tool.pose.linear() = Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  ASSERT_TRUE(well(rig.exchange(tool)));
  RobotCommand command = force_command(10);
  std::swap(command.force.behaviour[0], command.force.behaviour[1]);  // the tool's -y is the wall's x
  command.force.wrench << 0, 10, 0, 0, 0, 0;
  command.force.admittance[1] = 0.01;
  command.force.inertia[1] = 1;
  const RobotState state = rig.repeat(command, 200);
  ASSERT_TRUE(well(state)) << state.error.detail.view();
  EXPECT_NEAR(state.wrench[1], 10, 0.1);
  EXPECT_NEAR(state.joints[0], 0.11, 2e-4);
}

}  // namespace
}  // namespace mrroc::edp::force_test
