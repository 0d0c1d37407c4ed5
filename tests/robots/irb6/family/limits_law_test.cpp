#include <gtest/gtest.h>

#include <iostream>

#include "robots/irb6/family/robot_under_test.hpp"

namespace mrroc {
namespace {

TEST(LimitsLaw, AllModelsShareThem) {
  for (const auto& model : robot_under_test().models) {
    for (std::size_t i = 0; i < model->parameters().axes.size(); ++i) {
      const AxisParameters &mine = model->parameters().axes[i], &first = robot().parameters().axes[i];
      EXPECT_EQ(mine.name, first.name);
      EXPECT_EQ(mine.position_min, first.position_min);
      EXPECT_EQ(mine.position_max, first.position_max);
      EXPECT_EQ(mine.motor_synchro, first.motor_synchro);
    }
  }
}

TEST(LimitsLaw, AllMotorLimitsAreReachedByTheScrewsAndRodsAlone) {
  const JointVector low = per_axis(&AxisParameters::motor_min), high = per_axis(&AxisParameters::motor_max);
  for (int corner = 0; corner < 1 << low.size(); ++corner) {
    JointVector motors(low.size()), joints, back;
    for (int i = 0; i < low.size(); ++i) motors[i] = (corner >> i & 1) != 0 ? high[i] : low[i];
    ASSERT_EQ(robot().motors_to_joints(motors, joints), ErrorCode::none);
    ASSERT_EQ(robot().joints_to_motors(joints, back), ErrorCode::none);
    EXPECT_LT((back - motors).cwiseAbs().maxCoeff(), 1e-9) << motors.transpose();
  }
}

TEST(LimitsLaw, EveryJointLimitIsWithinTheMotorLimitsInSomePosture) {
  std::mt19937_64 random(20060106);
  const JointVector low = per_axis(&AxisParameters::position_min), high = per_axis(&AxisParameters::position_max);
  for (int axis = 0; axis < low.size(); ++axis) {
    for (const double limit : {low[axis], high[axis]}) {
      bool reached = false;
      for (int i = 0; i < 20000 && !reached; ++i) {
        JointVector joints = random_joints(random);
        joints[axis] = limit;
        reached = within_motor_limits(joints);
      }
      EXPECT_TRUE(reached) << robot().parameters().axes[static_cast<std::size_t>(axis)].name << " at " << limit;
    }
  }
}

TEST(LimitsLaw, HomeIsWithinThemAndPointsTheToolDownAtShoulderHeight) {
  const JointVector home = robot().parameters().home;
  EXPECT_TRUE(within_motor_limits(home));
  Pose expected = Pose::Identity();
  expected.linear() = Eigen::Vector3d(1, -1, -1).asDiagonal();
  expected.translation() = arm().direct(home).translation();
  expected.translation().z() = 0;
  EXPECT_LT(pose_difference(arm().direct(home), expected), 1e-8);
  EXPECT_GT(expected.translation().x(), 0.5);
}

// all joints at full speed at once, in every combination of directions, in random postures
TEST(LimitsLaw, FrictionAtFullSpeedLeavesTheDrivesCurrent) {
  const JointVector speed = per_axis(&AxisParameters::velocity_max);
  const JointVector amperes_per_speed =
      per_axis(&AxisParameters::viscous_friction).cwiseQuotient(per_axis(&AxisParameters::torque_constant));
  constexpr std::uint64_t kSeed = 20060102;
  std::mt19937_64 random(kSeed);
  JointVector worst_share = JointVector::Zero(speed.size()), worst_speed = worst_share;
  for (int i = 0; i < 2000; ++i) {
    const JointMatrix g = robot().transmission(random_posture(random));
    const JointVector motor_speed = g.cwiseAbs() * speed;
    worst_speed = worst_speed.cwiseMax(motor_speed);
    worst_share = worst_share.cwiseMax(
        motor_speed.cwiseProduct(amperes_per_speed).cwiseQuotient(per_axis(&AxisParameters::current_max)));
  }
  std::cout << "seed " << kSeed << ": worst motor speeds, rad/s: " << worst_speed.transpose() << "\n";
  EXPECT_LT(worst_share.maxCoeff(), 0.95) << worst_share.transpose();
  EXPECT_LT(worst_speed.maxCoeff(), 250) << "the original's panic speed";
}

}  // namespace
}  // namespace mrroc
