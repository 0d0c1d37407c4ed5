#include <gtest/gtest.h>

#include "robots/common/any_number.hpp"
#include "robots/conveyor/conveyor_fixture.hpp"

namespace mrroc {
namespace {

TEST(ConveyorTransmission, MotorsReturnToTheirJoints) {
  EXPECT_TRUE(rc::check([] {
    const double travel = any_between(-1e6, 1e6);
    JointVector motors, back;
    RC_ASSERT(conveyor_model()->joints_to_motors(one(travel), motors) == ErrorCode::none);
    RC_ASSERT(conveyor_model()->motors_to_joints(motors, back) == ErrorCode::none);
    RC_ASSERT(std::abs(back[0] - travel) <= 1e-15 * std::abs(travel));
  }));
}

TEST(ConveyorTransmission, HasOnlyTheLimitsOfNumbers) {
  EXPECT_EQ(belt().position_min, -std::numeric_limits<double>::infinity());
  EXPECT_EQ(belt().position_max, std::numeric_limits<double>::infinity());
  EXPECT_EQ(belt().motor_min, -std::numeric_limits<double>::infinity());
  EXPECT_EQ(belt().motor_max, std::numeric_limits<double>::infinity());
  JointVector motors = one(7);
  EXPECT_EQ(conveyor_model()->joints_to_motors(one(1e307), motors), ErrorCode::joint_limit);
  EXPECT_EQ(motors, one(7)) << "unchanged";
}

TEST(ConveyorTransmission, InvalidInputGivesACodeOrFiniteNumbers) {
  EXPECT_TRUE(rc::check([] {
    const JointVector garbage = one(any_garbage());
    JointVector result = one(7);
    const bool to_motors = conveyor_model()->joints_to_motors(garbage, result) == ErrorCode::none;
    RC_ASSERT(result.allFinite() && (to_motors || result == one(7)));
    result = one(7);
    const bool to_joints = conveyor_model()->motors_to_joints(garbage, result) == ErrorCode::none;
    RC_ASSERT(result.allFinite() && (to_joints || result == one(7)));
    RC_ASSERT(garbage.allFinite() || !(to_motors || to_joints));
  }));
}

}  // namespace
}  // namespace mrroc
