// Changes of a robot by a task: tool, kinematic model; and the recovery from a fault.
#include <gtest/gtest.h>

#include <cmath>

#include "edp/rig.hpp"

namespace mrroc::edp::change_test {
namespace {

/// A planar arm with longer links and gears with another zero.
class Measured : public PlanarArm {
 public:
  std::string_view name() const noexcept override { return "measured"; }
  ErrorCode motors_to_joints(const JointVector& motors, JointVector& joints) const noexcept override {
    joints = motors / kGear + JointVector::Constant(2, kOffset);
    return ErrorCode::none;
  }
  ErrorCode joints_to_motors(const JointVector& joints, JointVector& motors) const noexcept override {
    motors = kGear * (joints - JointVector::Constant(2, kOffset));
    return ErrorCode::none;
  }
  static constexpr double kOffset = 0.01;
};

/// A rig of two models.
struct TwoModels {
  TwoModels() {
    effector.enable(true);
    tick();
  }
  void tick() {
    servo.tick(now++);
    Reply reply;
    while (effector.poll(reply)) replies.push_back(reply);
  }
  Reply exchange(const RobotCommand& command) {
    replies.clear();
    Reply answer;
    if (effector.accept(command, 1, answer)) return answer;
    while (replies.empty() && now < 100'000) tick();
    return replies.at(0);
  }

  RobotModels list{std::make_shared<PlanarArm>(), std::make_shared<Measured>()};
  ModelSet models{list};
  LoopbackHardware hardware{*list[0], kPeriod};
  ServoChannel hand_over;
  Servo servo{models, hardware, kPeriod, hand_over};
  Effector effector{models, kPeriod, hand_over};
  Tick now = 0;
  std::vector<Reply> replies;
};

RobotCommand use_model(std::uint8_t model) {
  RobotCommand command;
  command.kind = CommandKind::use_model;
  command.choice = model;
  return command;
}

TEST(Change, AnotherModelGivesOtherJointsForTheSameShaftsWithoutMotion) {
  TwoModels rig;
  const RobotState before = rig.exchange(RobotCommand{}).state;
  const RobotState after = rig.exchange(use_model(1)).state;
  ASSERT_EQ(after.error.error_class, ErrorClass::none) << after.error.detail.view();
  EXPECT_EQ(after.model, 1);
  EXPECT_EQ(after.motors, before.motors);
  EXPECT_NEAR(after.joints[0], before.joints[0] + Measured::kOffset, 1e-12);
  EXPECT_NEAR(after.desired_joints[1], before.desired_joints[1] + Measured::kOffset, 1e-12);
  const RobotState moved = rig.exchange(joint_command(after.desired_joints, 100, 100)).state;
  EXPECT_NEAR((moved.motors - before.motors).norm(), 0, 2e-3);  // two encoder increments
  const RobotState back = rig.exchange(use_model(0)).state;
  EXPECT_EQ(back.model, 0);
  EXPECT_NEAR(back.desired_joints[0], before.desired_joints[0], 1e-12);
}

TEST(Change, CommandFromBeforeTheChangeIsPlannedWithTheNewModel) {
  TwoModels rig;
  const RobotState before = rig.exchange(RobotCommand{}).state;
  Reply answer;
  ASSERT_FALSE(rig.effector.accept(use_model(1), 1, answer));
  RobotCommand absolute = joint_command(before.desired_joints, 200, 200);
  ASSERT_FALSE(rig.effector.accept(absolute, 2, answer));
  rig.replies.clear();
  while (rig.replies.size() < 2) rig.tick();
  EXPECT_NEAR(rig.replies[1].state.desired_joints[0], before.desired_joints[0], 1e-12);
  EXPECT_NEAR(rig.replies[1].state.desired_joints[0] - Measured::kOffset, before.motors[0] / GearedModel::kGear - 0.01,
              1e-4);
}

TEST(Change, RefusesAnUnknownModel) {
  TwoModels rig;
  const RobotState state = rig.exchange(use_model(2)).state;
  EXPECT_EQ(state.error.code, ErrorCode::invalid_argument);
  EXPECT_EQ(state.error.detail.view(), "model 2, expected 0..1");
}

TEST(Change, PosesAreOfTheCurrentTool) {
  Rig<PlanarArm> rig;
  const RobotState bare = rig.query();
  RobotCommand command;
  command.kind = CommandKind::set_tool;
  command.pose = Eigen::Translation3d(0.1, 0, 0);
  ASSERT_TRUE(rig.send(command));
  ASSERT_EQ(rig.answer.state.error.error_class, ErrorClass::none);
  EXPECT_TRUE(rig.answer.state.tool.isApprox(command.pose));
  EXPECT_TRUE(rig.answer.state.desired_pose.isApprox(bare.desired_pose * command.pose));
  RobotCommand pose;
  pose.kind = CommandKind::pose;
  pose.relative = true;
  pose.motion_steps = pose.reply_step = 1000;
  pose.pose = Pose(Eigen::AngleAxisd(0.01, Eigen::Vector3d::UnitZ()));
  rig.send(pose);
  EXPECT_EQ(rig.answer.state.error.code, ErrorCode::out_of_workspace);  // a planar arm cannot turn without moving
  command.pose.linear() *= 2;
  ASSERT_TRUE(rig.send(command));
  EXPECT_EQ(rig.answer.state.error.code, ErrorCode::invalid_argument);
}

TEST(Change, DoesNotWaitAndRefusesAMovingRobot) {
  Rig<Slide> rig;
  RobotCommand run_up = joint_command(one(0.4), 200, 100);
  run_up.joint_velocity = one(0.5);
  run_up.joint_acceleration = one(0);
  ASSERT_FALSE(rig.send(run_up));
  RobotCommand tool;
  tool.kind = CommandKind::set_tool;
  ASSERT_TRUE(rig.send(tool));
  EXPECT_EQ(rig.answer.state.error.code, ErrorCode::busy);
}

TEST(Change, FollowsTheStopThatAHoldHasBegun) {
  TwoModels rig;
  RobotCommand away = joint_command(rig.exchange(RobotCommand{}).state.desired_joints, 100, 100);
  away.joints[0] += 0.05;
  away.joint_velocity = JointVector::Zero(2);
  away.joint_velocity[0] = 0.5;
  ASSERT_EQ(rig.exchange(away).state.error.error_class, ErrorClass::none);
  RobotCommand hold;
  hold.kind = CommandKind::hold;
  hold.motion_steps = 4;
  hold.reply_step = 3;
  const RobotState held = rig.exchange(hold).state;
  ASSERT_EQ(held.error.error_class, ErrorClass::none) << held.error.detail.view();
  EXPECT_NE(held.desired_velocity[0], 0) << "in the middle of the stop";
  const RobotState after = rig.exchange(use_model(1)).state;
  EXPECT_EQ(after.error.error_class, ErrorClass::none) << after.error.detail.view();
  EXPECT_EQ(after.model, 1);
  EXPECT_TRUE(after.desired_velocity.isZero(0));
  EXPECT_GT(after.tick, held.desired_tick + 5) << "the stop first";
}

TEST(Change, RecoverClearsAFaultAndTheRobotStandsWhereItIs) {
  Rig<Slide> rig;
  ASSERT_FALSE(rig.send(joint_command(one(0.5), 300, 300)));
  rig.run(150);
  rig.hardware.fault = ErrorCode::drive_fault;
  rig.run(300);
  ASSERT_FALSE(rig.hardware.powered);
  rig.replies.clear();
  RobotCommand recover;
  recover.kind = CommandKind::recover;
  // the cause is still there: the answer is the fault
  ASSERT_FALSE(rig.send(recover));
  rig.run(300);
  ASSERT_EQ(rig.replies.size(), 1u);
  EXPECT_EQ(rig.replies[0].state.error.code, ErrorCode::drive_fault);
  EXPECT_FALSE(rig.hardware.powered);
  // the cause is gone
  rig.hardware.fault = ErrorCode::none;
  rig.replies.clear();
  ASSERT_FALSE(rig.send(recover));
  rig.run(3);
  ASSERT_EQ(rig.replies.size(), 1u);
  const RobotState& state = rig.replies[0].state;
  EXPECT_EQ(state.error.error_class, ErrorClass::none) << state.error.detail.view();
  EXPECT_TRUE(state.enabled);
  EXPECT_EQ(state.desired_joints, state.joints);  // no jump
  const double stood = state.joints[0];
  rig.run(300);
  EXPECT_EQ(rig.seen().joints[0], stood);
  ASSERT_FALSE(rig.send(joint_command(one(0.5), 500, 500)));
  rig.run(600);
  EXPECT_NEAR(rig.seen().joints[0], 0.5, 1e-3);
}

TEST(Change, NoRecoveryPowersDrivesThatHaveLostTheirPositions) {
  Rig<Slide> rig;
  rig.run(10);
  rig.hardware.positions_lost = true;
  rig.run(300);
  ASSERT_FALSE(rig.hardware.powered);
  RobotCommand recover;
  recover.kind = CommandKind::recover;
  rig.replies.clear();
  ASSERT_FALSE(rig.send(recover));
  ASSERT_TRUE(rig.send(recover)) << "one at a time";
  EXPECT_EQ(rig.answer.state.error.code, ErrorCode::busy);
  for (int i = 0; i < 300; ++i) {
    rig.tick();
    ASSERT_FALSE(rig.hardware.powered);
  }
  ASSERT_EQ(rig.replies.size(), 1u);
  EXPECT_EQ(rig.replies[0].state.error.code, ErrorCode::drive_fault);
  rig.hardware.positions_lost = false;
  ASSERT_FALSE(rig.send(recover));
  rig.run(3);
  ASSERT_EQ(rig.replies.size(), 2u);
  EXPECT_EQ(rig.replies[1].state.error.code, ErrorCode::none);
  EXPECT_TRUE(rig.hardware.powered);
}

TEST(Change, RefusesAStartTickThatNeverComes) {
  Rig<Slide> rig;
  for (const CommandKind kind : {CommandKind::use_regulators, CommandKind::use_model, CommandKind::joint}) {
    RobotCommand command = joint_command(one(0.3), 100, 100);
    command.kind = kind;
    command.start_tick = kNever;
    ASSERT_TRUE(rig.send(command));
    EXPECT_EQ(rig.answer.state.error.code, ErrorCode::invalid_argument);
  }
}

TEST(Change, OutputsAreSetAtAnyTimeAndReportedInTheState) {
  Rig<Slide> rig(false);  // the drives are off
  RobotCommand set;
  set.kind = CommandKind::set_outputs;
  set.outputs.set(3, true);
  set.outputs.analog[2] = 1.5;
  ASSERT_TRUE(rig.send(set));
  EXPECT_EQ(rig.answer.state.error.error_class, ErrorClass::none) << rig.answer.state.error.detail.view();
  rig.tick();
  EXPECT_EQ(rig.query().outputs, set.outputs);
  rig.tick();
  EXPECT_EQ(rig.query().inputs, set.outputs) << "the loopback's outputs are wired to its inputs";
  set.outputs.analog[5] = std::nan("");
  ASSERT_TRUE(rig.send(set));
  EXPECT_EQ(rig.answer.state.error.code, ErrorCode::not_finite);
}

TEST(Change, OutputsOfAMotionAreSetWithItsMacrostep) {
  Rig<Slide> rig;
  ASSERT_FALSE(rig.send(joint_command(one(0.3), 200, 200)));
  RobotCommand next = joint_command(one(0.25), 200, 200);
  next.with_outputs = true;
  next.outputs.set(0, true);
  ASSERT_FALSE(rig.send(next));
  rig.run(199);
  EXPECT_FALSE(rig.query().outputs.on(0));
  rig.run(3);
  EXPECT_TRUE(rig.query().outputs.on(0));
  rig.run(300);
  next.outputs.analog[0] = INFINITY;
  ASSERT_TRUE(rig.send(next));
  EXPECT_EQ(rig.answer.state.error.code, ErrorCode::not_finite);
}

/// A slide with a second set of regulators.
class TwoServos : public Slide {
 public:
  TwoServos() {
    parameters_.regulators = {{"standard", parameters_.axes}, {"soft", parameters_.axes}};
    parameters_.regulators[1].axes[0].regulator_current_gain *= 0.25;
  }
};

TEST(Change, AnotherRegulatorSetIsInForceFromThenOn) {
  const auto largest_error = [](bool soft) {
    Rig<TwoServos> rig;
    RobotCommand use;
    use.kind = CommandKind::use_regulators;
    use.choice = soft ? 1 : 0;
    EXPECT_FALSE(rig.send(use));
    rig.run(3);
    EXPECT_EQ(rig.replies.at(0).state.regulators, soft ? 1 : 0);
    EXPECT_FALSE(rig.send(joint_command(one(0.5), 300, 300)));
    rig.run(600);
    EXPECT_NEAR(rig.seen().joints[0], 0.5, 1e-3) << "it still reaches its target";
    return rig.seen().counters.following_error[0];
  };
  EXPECT_GT(largest_error(true), 1.5 * largest_error(false));
}

TEST(Change, RefusesAnUnknownRegulatorSetAndAnyInMotion) {
  Rig<TwoServos> rig;
  RobotCommand use;
  use.kind = CommandKind::use_regulators;
  use.choice = 2;
  ASSERT_TRUE(rig.send(use));
  EXPECT_EQ(rig.answer.state.error.code, ErrorCode::invalid_argument);
  RobotCommand moving = joint_command(one(0.3), 300, 300);
  moving.joint_velocity = one(0.1);
  ASSERT_FALSE(rig.send(moving));
  use.choice = 1;
  ASSERT_TRUE(rig.send(use));
  EXPECT_EQ(rig.answer.state.error.code, ErrorCode::busy);
}

}  // namespace
}  // namespace mrroc::edp::change_test
