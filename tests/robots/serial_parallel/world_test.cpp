#include "world_fixture.hpp"

namespace mrroc::world_test {
namespace {

TEST_F(SerialParallelWorld, StartsAtHomeWithItsLoopsClosed) {
  EXPECT_LT(residual(), 1e-12);
  EXPECT_LT(pose_difference(tool_in_world(), SerialParallel::tool_down(0, 0, 0.6 - 0.5305)), 1e-9);
}

TEST_F(SerialParallelWorld, RegulatorsHoldItAgainstGravity) {
  const JointVector home = machine().parameters().home;
  JointVector sag = JointVector::Zero(6);
  for (int i = 0; i < 1000; ++i) {
    run(1);
    sag = sag.cwiseMax((servo.snapshot().joints - home).cwiseAbs());
  }
  const JointVector rest = (servo.snapshot().joints - home).cwiseAbs();
  std::printf("sag at home: legs %.1e m, wrist %.1e rad; after two seconds %.1e m, %.1e rad; loops %.1e m\n",
              sag.head<3>().maxCoeff(), sag.tail<3>().maxCoeff(), rest.head<3>().maxCoeff(), rest.tail<3>().maxCoeff(),
              worst_residual);
  EXPECT_LT(sag.head<3>().maxCoeff(), 1e-4);
  EXPECT_LT(sag.tail<3>().maxCoeff(), 0.01);
  EXPECT_LT(rest.head<3>().maxCoeff(), 2e-6);
  EXPECT_LT(rest.tail<3>().maxCoeff(), 1e-4);
  EXPECT_LT(worst_residual, 1e-5);
}

// over the corners of a board, 40 mm up and down, at a considerable part of the legs' speed
TEST_F(SerialParallelWorld, ReachesItsTargetsWithItsLoopsClosed) {
  double worst_model_error = 0;
  for (const auto& [x, y, z] : {std::array{-0.05, -0.1, -0.565},
                                {0.15, 0.1, -0.525},
                                {-0.05, 0.1, -0.525},
                                {0.15, -0.1, -0.565},
                                {0.05, 0.0, -0.545}}) {
    const JointVector target = down_at(x, y, z);
    go(target, 2500);
    if (HasFatalFailure()) return;
    EXPECT_LT((servo.snapshot().joints - target).head<3>().cwiseAbs().maxCoeff(), 5e-6);
    EXPECT_LT((servo.snapshot().joints - target).tail<3>().cwiseAbs().maxCoeff(), 1e-3);
    worst_model_error = std::max(worst_model_error, model_error());
  }
  std::printf("loops within %.1e m in motion, tool within %.1e m or rad of the model at rest\n", worst_residual,
              worst_model_error);
  EXPECT_LT(worst_residual, 1e-5);
  EXPECT_LT(worst_model_error, 1e-5);
}

// the motions of engraving: a stream of poses with their twists, each in time for the previous one
TEST_F(SerialParallelWorld, DrawsAStraightLineAcrossTheBoard) {
  constexpr int kSteps = 250, kTicks = 10;
  const Eigen::Vector3d from(-0.03, -0.09, -0.55), way(0.16, 0.18, 0);
  go(down_at(from.x(), from.y(), from.z()), 2500);
  if (HasFatalFailure()) return;
  const auto command_of = [&](int step) {
    // u^3 (10 - 15 u + 6 u^2): starts and ends without acceleration
    const double u = static_cast<double>(step) / kSteps, duration = kSteps * kTicks * kPeriod;
    const Eigen::Vector3d point = from + way * (u * u * u * (10 - 15 * u + 6 * u * u));
    RobotCommand command;
    command.kind = CommandKind::pose;
    command.interpolation = Interpolation::task;
    command.motion_steps = command.reply_step = kTicks;
    command.pose = SerialParallel::tool_down(point.x(), point.y(), point.z());
    command.twist.head<3>() = way * (30 * u * u * (1 - u) * (1 - u) / duration);
    command.twist_acceleration = JointVector::Zero(6);
    command.twist_acceleration.head<3>() = way * (60 * u * (1 - u) * (1 - 2 * u) / (duration * duration));
    return command;
  };
  double off_the_line = 0, off_upright = 0;
  for (int step = 1; step <= kSteps; ++step) {
    edp::Reply refusal;
    ASSERT_FALSE(effector.accept(command_of(step), ++number, refusal)) << refusal.state.error.detail.view();
    for (int i = 0; i < (step == 1 ? kTicks / 2 : kTicks); ++i) {
      run(1);
      const Pose tool = tool_in_world();
      const Eigen::Vector3d since = tool.translation() - Eigen::Vector3d(0, 0, 0.6) - from;
      off_the_line = std::max(off_the_line, (since - way * way.dot(since) / way.squaredNorm()).norm());
      off_upright = std::max(off_upright, (tool.linear().col(2) + Eigen::Vector3d::UnitZ()).norm());
    }
  }
  run(100);
  ASSERT_EQ(last.error.error_class, ErrorClass::none) << last.error.detail.view();
  const Eigen::Vector3d end = tool_in_world().translation() - Eigen::Vector3d(0, 0, 0.6);
  std::printf(
      "a line of %.2f m in %.1f s: tip within %.1e m, spindle within %.1e rad; its end within %.1e m; loops %.1e m\n",
      way.norm(), kSteps * kTicks * kPeriod, off_the_line, off_upright, (end - from - way).norm(), worst_residual);
  EXPECT_LT(off_the_line, 1e-4);
  EXPECT_LT(off_upright, 3e-3);
  EXPECT_LT((end - from - way).norm(), 2e-5);
  EXPECT_LT(worst_residual, 1e-5);
}

TEST_F(SerialParallelWorld, JointsBeyondAPassiveLimitAreRefusedBeforeAnyMotion) {
  RobotCommand command;
  command.kind = CommandKind::joint;
  command.joints = machine().parameters().home;
  command.joints[0] -= 0.035;
  command.joints[2] += 0.035;  // each leg within its limits, both together tilt too far
  command.motion_steps = command.reply_step = 5000;
  edp::Reply refusal;
  ASSERT_TRUE(effector.accept(command, ++number, refusal));
  EXPECT_EQ(refusal.state.error.error_class, ErrorClass::non_fatal) << refusal.state.error.detail.view();
  EXPECT_EQ(refusal.state.error.code, ErrorCode::motor_limit) << refusal.state.error.detail.view();
  run(10);
  EXPECT_TRUE(servo.snapshot().enabled());
}

TEST_F(SerialParallelWorld, BrakesHoldItsPosition) {
  run(100);
  effector.enable(false);
  run(5);
  const JointVector held = servo.snapshot().joints;
  run(500);
  EXPECT_LT((servo.snapshot().joints - held).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT(worst_residual, 1e-5);
}

}  // namespace
}  // namespace mrroc::world_test
