#include <gtest/gtest.h>

#include "robots/common/drive_model.hpp"
#include "robots/irb6/family/robot_under_test.hpp"

namespace mrroc {
namespace {

TEST(Irb6Servo, FullGainOfTheWristRollDoesNotTolerateATickOfDelay) {
  AxisParameters axis = robot().parameters().axes[4];
  ASSERT_EQ(axis.name, "wrist_roll");
  axis.regulator_current_gain = 0.110;
  EXPECT_GT(track_by_servo(axis, 1).final, 0.1) << "the reason for the reduced gain is gone";
}

}  // namespace
}  // namespace mrroc
