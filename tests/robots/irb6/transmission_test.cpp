#include <gtest/gtest.h>

#include <cmath>

#include "robots/irb6/family/cases.hpp"

namespace mrroc {
namespace {

TEST(Irb6Transmission, WristRollTurnsAlongWithThePitchMotor) {
  const JointVector home = robot().parameters().home;
  JointVector pitched = home, motors_home, motors_pitched;
  pitched[3] += 0.1;
  ASSERT_EQ(robot().joints_to_motors(home, motors_home), ErrorCode::none);
  ASSERT_EQ(robot().joints_to_motors(pitched, motors_pitched), ErrorCode::none);
  const JointVector change = motors_pitched - motors_home;
  EXPECT_NEAR(change[3], -12.8, 1e-9);
  EXPECT_NEAR(change[4], -12.8, 1e-9);
  EXPECT_NEAR(change.head<3>().norm() + std::abs(change[5]), 0, 1e-9);
}

// the lower arm's screw has its dead centres at t2 = -154.27 and 25.73 deg, the upper arm's at t3 = -49.28, 130.72 deg
TEST(Irb6Transmission, ScrewsEndAtTheirDeadCentres) {
  constexpr double kDegree = M_PI / 180;
  const auto code = [](double t2, double t3) {
    JointVector joints(6), motors = JointVector::Constant(6, 7);
    joints << 0, t2, t3 - t2 - M_PI / 2, 0, 0, 0;
    const ErrorCode result = robot().joints_to_motors(joints, motors);
    if (result != ErrorCode::none) {
      EXPECT_EQ(motors, JointVector::Constant(6, 7)) << "unchanged";
    }
    return result;
  };
  EXPECT_EQ(code(-154 * kDegree, 0), ErrorCode::none);
  EXPECT_EQ(code(-155 * kDegree, 0), ErrorCode::joint_limit);
  EXPECT_EQ(code(25 * kDegree, 0), ErrorCode::none);
  EXPECT_EQ(code(26 * kDegree, 0), ErrorCode::joint_limit);
  EXPECT_EQ(code(-90 * kDegree, -49 * kDegree), ErrorCode::none);
  EXPECT_EQ(code(-90 * kDegree, -50 * kDegree), ErrorCode::joint_limit);
  EXPECT_EQ(code(-90 * kDegree, 130 * kDegree), ErrorCode::none);
  EXPECT_EQ(code(-90 * kDegree, 131 * kDegree), ErrorCode::joint_limit);
}

TEST(Irb6Transmission, ScrewLongerOrShorterThanItsTriangleHasNoAngle) {
  const JointVector synchro = per_axis(&AxisParameters::motor_synchro);
  for (const int screw : {1, 2}) {
    for (const double motor : {-400.0, -155.0, 400.0}) {
      JointVector motors = synchro, joints = JointVector::Constant(6, 7);
      motors[screw] = motor;
      EXPECT_EQ(robot().motors_to_joints(motors, joints), ErrorCode::motor_limit) << screw << ": " << motor;
      EXPECT_EQ(joints, JointVector::Constant(6, 7)) << "unchanged";
    }
  }
}

}  // namespace
}  // namespace mrroc
