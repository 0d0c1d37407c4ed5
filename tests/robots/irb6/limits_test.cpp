#include <gtest/gtest.h>

#include <cmath>

#include "robots/irb6/family/robot_under_test.hpp"

namespace mrroc {
namespace {

using Member = double AxisParameters::*;

TEST(Irb6Limits, JointLimitsOfFreeAxesAreWithinTheMotorLimits) {
  for (const int axis : {0, 1, 5}) {
    for (const Member limit : {&AxisParameters::position_min, &AxisParameters::position_max}) {
      JointVector joints = robot().parameters().home;
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
    const ErrorCode code = robot().joints_to_motors(joints, motors);
    if (code == ErrorCode::joint_limit) continue;
    ASSERT_EQ(code, ErrorCode::none);
    ASSERT_EQ(robot().motors_to_joints(motors, back), ErrorCode::none);
    EXPECT_LT((back - joints).cwiseAbs().maxCoeff(), 1e-9) << joints.transpose();
    ++reached;
    within_motors += within_motor_limits(joints) ? 1 : 0;
  }
  std::printf("of 64 corners the screws reach %d, %d of them within the motor limits\n", reached, within_motors);
  EXPECT_EQ(reached, 48);  // all except lower arm back with upper arm up
}

TEST(Irb6Limits, HomeIsWithinThemWithAMarginOnEveryMotor) {
  JointVector motors;
  ASSERT_EQ(robot().joints_to_motors(robot().parameters().home, motors), ErrorCode::none);
  const JointVector room =
      (motors - per_axis(&AxisParameters::motor_min))
          .cwiseMin(per_axis(&AxisParameters::motor_max) - motors)
          .cwiseQuotient(per_axis(&AxisParameters::motor_max) - per_axis(&AxisParameters::motor_min));
  EXPECT_GT(room.minCoeff(), 0.2) << room.transpose();
}

TEST(Irb6Limits, ToolMovesDownAndUpAtHomeWithinThem) {
  const JointVector low = per_axis(&AxisParameters::position_min), high = per_axis(&AxisParameters::position_max);
  const auto reached = [&](double direction) {
    JointVector joints = robot().parameters().home;
    Pose pose = arm().direct(joints);
    for (;;) {
      pose.translation().z() += direction * 0.001;
      if (arm().inverse(pose, joints, joints) != ErrorCode::none) break;
      if ((joints.array() < low.array()).any() || (joints.array() > high.array()).any()) break;
      if (!within_motor_limits(joints)) break;
    }
    return pose.translation().z();
  };
  EXPECT_NEAR(reached(-1), -0.194, 0.002);
  EXPECT_NEAR(reached(1), 0.484, 0.02);
}

}  // namespace
}  // namespace mrroc
