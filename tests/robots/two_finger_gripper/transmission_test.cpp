#include <gtest/gtest.h>

#include <cmath>

#include "gripper_fixture.hpp"
#include "robots/common/any_number.hpp"

namespace mrroc::transmission_test {
namespace {

double any_opening() { return any_between(opening_axis().position_min, opening_axis().position_max); }

// the original's two formulas with its own constants
double original_opening(double motor) { return -2.8313e-9 * motor * motor - 1.451910074e-5 * motor + 0.074; }
double original_motor(double opening) {
  return 0.3531946456e-5 * std::sqrt(0.2622172716e19 - 0.2831300000e20 * opening) - 2564.03432;
}

TEST(GripperTransmission, EqualsThatOfTheOriginal) {
  double worst_opening = 0, worst_motor = 0;
  for (double opening = 0.053; opening <= 0.091; opening += 0.0005) {
    const double motor = motor_of(opening);
    JointVector back;
    ASSERT_EQ(gripper_model()->motors_to_joints(one(motor), back), ErrorCode::none);
    worst_opening = std::max(worst_opening, std::abs(original_opening(motor) - back[0]));
    worst_motor = std::max(worst_motor, std::abs(original_motor(opening) - motor));
  }
  std::printf("from the original: openings %.1e m, motors %.1e rad\n", worst_opening, worst_motor);
  EXPECT_LT(worst_opening, 1e-15);
  EXPECT_LT(worst_motor, 1e-5) << "its inverse has ten digits";
}

TEST(GripperTransmission, MotorsReturnToTheirJoints) {
  EXPECT_TRUE(rc::check([] {
    const double opening = any_opening();
    JointVector back;
    RC_ASSERT(gripper_model()->motors_to_joints(one(motor_of(opening)), back) == ErrorCode::none);
    RC_ASSERT(std::abs(back[0] - opening) < 1e-15);
  }));
}

TEST(GripperTransmission, MatrixIsTheDerivativeOfTheMotorByTheOpening) {
  EXPECT_TRUE(rc::check([] {
    constexpr double kStep = 1e-7;
    const double opening = any_opening();
    const double slope = (motor_of(opening + kStep) - motor_of(opening - kStep)) / (2 * kStep);
    RC_ASSERT(std::abs(gripper_model()->transmission(one(opening))(0, 0) / slope - 1) < 1e-6);
  }));
}

TEST(GripperTransmission, MoreOpenGripperIsSlowerAndStronger) {
  double before = 0;
  for (double opening = 0.053; opening <= 0.091; opening += 0.001) {
    const double ratio = gripper_model()->transmission(one(opening))(0, 0);
    EXPECT_LT(ratio, before) << opening;
    before = ratio;
  }
}

TEST(GripperTransmission, HasNoValueBeyondItsDeadCentre) {
  JointVector result = one(7);
  EXPECT_EQ(gripper_model()->joints_to_motors(one(0.0926), result), ErrorCode::none);
  result = one(7);
  EXPECT_EQ(gripper_model()->joints_to_motors(one(0.0927), result), ErrorCode::joint_limit);
  EXPECT_EQ(gripper_model()->motors_to_joints(one(-2565), result), ErrorCode::motor_limit);
  EXPECT_EQ(result, one(7)) << "unchanged";
  EXPECT_EQ(gripper_model()->motors_to_joints(one(-2564), result), ErrorCode::none);
  EXPECT_NEAR(result[0], 0.0926137, 1e-7);
}

TEST(GripperTransmission, InvalidInputGivesACodeOrFiniteNumbers) {
  EXPECT_TRUE(rc::check([] {
    const JointVector garbage = one(any_garbage());
    JointVector result = one(7);
    const bool to_motors = gripper_model()->joints_to_motors(garbage, result) == ErrorCode::none;
    RC_ASSERT(result.allFinite() && (to_motors || result == one(7)));
    result = one(7);
    const bool to_joints = gripper_model()->motors_to_joints(garbage, result) == ErrorCode::none;
    RC_ASSERT(result.allFinite() && (to_joints || result == one(7)));
    RC_ASSERT(garbage.allFinite() || !(to_motors || to_joints));
    if (garbage.allFinite()) RC_ASSERT(gripper_model()->transmission(garbage).allFinite());
  }));
}

}  // namespace
}  // namespace mrroc::transmission_test
