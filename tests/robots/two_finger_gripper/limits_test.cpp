#include <gtest/gtest.h>

#include "gripper_fixture.hpp"

namespace mrroc::limits_test {
namespace {

TEST(GripperLimits, JointLimitsAndHomeAreWithinTheMotorLimits) {
  for (const double opening : {opening_axis().position_min, opening_axis().position_max}) {
    EXPECT_GT(motor_of(opening), opening_axis().motor_min) << opening;
    EXPECT_LT(motor_of(opening), opening_axis().motor_max) << opening;
  }
  const double home = gripper_model()->parameters().home[0];
  EXPECT_GT(home, 0.057 + 0.01) << "wide enough for the original's cube";
  EXPECT_LT(home, opening_axis().position_max);
}

// at every opening: friction at full speed and the steepest path that the EDP accepts, or the start from rest at it
TEST(GripperLimits, DriveHasTheCurrentForThem) {
  const double limit = opening_axis().regulator_output_max * opening_axis().regulator_current_gain;
  const double braking =
      opening_axis().velocity_max * opening_axis().velocity_max / (2 * opening_axis().acceleration_max);
  double worst = 0, fastest = 0;
  for (double opening = 0.053; opening <= 0.091; opening += 0.0005) {
    const double ratio = std::abs(gripper_model()->transmission(one(opening))(0, 0));
    // it cannot move at full speed within the braking distance of a limit
    const double room = std::min(opening_axis().position_max - opening, opening - opening_axis().position_min) + 0.0005;
    const double speed = opening_axis().velocity_max * std::sqrt(std::min(1.0, room / braking));
    const double friction = opening_axis().viscous_friction * ratio * speed;
    const double inertia = opening_axis().rotor_inertia * ratio * 1.5 * opening_axis().acceleration_max;
    worst = std::max(worst, (friction + inertia) / opening_axis().torque_constant);
    fastest = std::max(fastest, ratio * speed);
  }
  std::printf("worst current %.1f mA of %.1f mA, motor %.0f rad/s\n", 1000 * worst, 1000 * limit, fastest);
  EXPECT_LT(worst, limit);
  EXPECT_LT(limit, opening_axis().current_max);
}

TEST(GripperLimits, GripForceIsThatOfTheParameterFile) {
  const double current = opening_axis().regulator_output_max * opening_axis().regulator_current_gain;
  const double force = -gripper_model()->transmission(one(0.057))(0, 0) * opening_axis().torque_constant * current;
  EXPECT_NEAR(force, 186, 1);
  // closing to 4 mm less than the smallest grippable part is not a following error
  EXPECT_LT(motor_of(0.053) - motor_of(0.057), opening_axis().following_error_max);
}

}  // namespace
}  // namespace mrroc::limits_test
