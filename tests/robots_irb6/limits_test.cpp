#include <gtest/gtest.h>

#include <cmath>

#include "irb6_fixture.hpp"

namespace mrroc {
namespace {

using Member = double AxisParameters::*;

TEST(Irb6Limits, JointLimitsOfFreeAxesAreWithinTheMotorLimits) {
  for (const int axis : {0, 1, 5}) {
    for (const Member limit : {&AxisParameters::position_min, &AxisParameters::position_max}) {
      JointVector joints = irb6_model().parameters().home;
      // with the upper arm level, the lower arm's screw alone decides
      joints[1] = axis == 1 ? per_axis(limit)[1] : joints[1];
      joints[2] = -joints[1] - M_PI / 2;
      joints[3] = 0;
      joints[axis] = per_axis(limit)[axis];
      EXPECT_TRUE(within_motor_limits(joints)) << axis;
    }
  }
}

// motors 3, 4 and 5 turn with sums of joints: their limits cut corners off the joint limits
TEST(Irb6Limits, EveryCornerOfTheJointLimitsConvertsBackOrIsRefused) {
  const JointVector low = per_axis(&AxisParameters::position_min), high = per_axis(&AxisParameters::position_max);
  int reached = 0, within_motors = 0;
  for (int corner = 0; corner < 64; ++corner) {
    JointVector joints(6), motors, back;
    for (int i = 0; i < 6; ++i) joints[i] = (corner >> i & 1) != 0 ? high[i] : low[i];
    const ErrorCode code = irb6_model().joints_to_motors(joints, motors);
    if (code == ErrorCode::joint_limit) continue;
    ASSERT_EQ(code, ErrorCode::none);
    ASSERT_EQ(irb6_model().motors_to_joints(motors, back), ErrorCode::none);
    EXPECT_LT((back - joints).cwiseAbs().maxCoeff(), 1e-9) << joints.transpose();
    ++reached;
    within_motors += within_motor_limits(joints) ? 1 : 0;
  }
  std::printf("of 64 corners the screws reach %d, %d of them within the motor limits\n", reached, within_motors);
  EXPECT_EQ(reached, 48);  // all but lower arm back with upper arm up
}

TEST(Irb6Limits, AllMotorLimitsAreReachedByTheScrewsAndRodsAlone) {
  const JointVector low = per_axis(&AxisParameters::motor_min), high = per_axis(&AxisParameters::motor_max);
  for (int corner = 0; corner < 64; ++corner) {
    JointVector motors(6), joints, back;
    for (int i = 0; i < 6; ++i) motors[i] = (corner >> i & 1) != 0 ? high[i] : low[i];
    ASSERT_EQ(irb6_model().motors_to_joints(motors, joints), ErrorCode::none);
    ASSERT_EQ(irb6_model().joints_to_motors(joints, back), ErrorCode::none);
    EXPECT_LT((back - motors).cwiseAbs().maxCoeff(), 1e-9) << motors.transpose();
  }
}

TEST(Irb6Limits, HomeIsWithinThemWithRoomOnEveryMotor) {
  JointVector motors;
  ASSERT_EQ(irb6_model().joints_to_motors(irb6_model().parameters().home, motors), ErrorCode::none);
  const JointVector room =
      (motors - per_axis(&AxisParameters::motor_min))
          .cwiseMin(per_axis(&AxisParameters::motor_max) - motors)
          .cwiseQuotient(per_axis(&AxisParameters::motor_max) - per_axis(&AxisParameters::motor_min));
  EXPECT_GT(room.minCoeff(), 0.2) << room.transpose();
}

TEST(Irb6Limits, HomePointsTheToolDownAtShoulderHeight) {
  Pose expected = Pose::Identity();
  expected.linear() = Eigen::Vector3d(1, -1, -1).asDiagonal();
  expected.translation() << 0.75, 0, 0;
  EXPECT_LT(pose_difference(irb6_kinematics().direct(irb6_model().parameters().home), expected), 1e-8);
}

TEST(Irb6Limits, TheToolComesDownAndGoesUpAtHomeWithoutLeavingThem) {
  const JointVector low = per_axis(&AxisParameters::position_min), high = per_axis(&AxisParameters::position_max);
  const auto reached = [&](double direction) {
    JointVector joints = irb6_model().parameters().home;
    Pose pose = irb6_kinematics().direct(joints);
    for (;;) {
      pose.translation().z() += direction * 0.001;
      if (irb6_kinematics().inverse(pose, joints, joints) != ErrorCode::none) break;
      if ((joints.array() < low.array()).any() || (joints.array() > high.array()).any()) break;
      if (!within_motor_limits(joints)) break;
    }
    return pose.translation().z();
  };
  EXPECT_NEAR(reached(-1), -0.194, 0.002);
  EXPECT_NEAR(reached(1), 0.484, 0.02);
}

// all joints at full speed at once, in every combination of directions, in random postures
TEST(Irb6Limits, FrictionAtFullSpeedLeavesTheDrivesCurrent) {
  const JointVector speed = per_axis(&AxisParameters::velocity_max);
  const JointVector amperes_per_speed =
      per_axis(&AxisParameters::viscous_friction).cwiseQuotient(per_axis(&AxisParameters::torque_constant));
  constexpr std::uint64_t kSeed = 20060102;
  std::mt19937_64 random(kSeed);
  JointVector worst_share = JointVector::Zero(6), worst_speed = JointVector::Zero(6);
  for (int i = 0; i < 2000; ++i) {
    const JointMatrix g = irb6_model().transmission(random_posture(random));
    const JointVector motor_speed = g.cwiseAbs() * speed;
    worst_speed = worst_speed.cwiseMax(motor_speed);
    worst_share = worst_share.cwiseMax(
        motor_speed.cwiseProduct(amperes_per_speed).cwiseQuotient(per_axis(&AxisParameters::current_max)));
  }
  std::printf("seed %llu: worst motor speeds %.0f %.0f %.0f %.0f %.0f %.0f rad/s\n",
              static_cast<unsigned long long>(kSeed), worst_speed[0], worst_speed[1], worst_speed[2], worst_speed[3],
              worst_speed[4], worst_speed[5]);
  EXPECT_LT(worst_share.maxCoeff(), 0.95) << worst_share.transpose();
  EXPECT_LT(worst_speed.maxCoeff(), 250) << "the original's panic speed";
}

}  // namespace
}  // namespace mrroc
