#include <gtest/gtest.h>

#include "robots/common/regulator_tracking.hpp"
#include "robots/conveyor/conveyor_fixture.hpp"

namespace mrroc {
namespace {

TEST(ConveyorServo, OriginalLawTracksAlsoWithATickOfDelay) {
  for (const int delay : {0, 1}) {
    const Tracking result = track_by_regulator(belt(), 100, delay);  // 79 rad/s at most
    std::printf("delay %d: worst %.3f rad, final %.1e rad, peak %.1f A\n", delay, result.worst, result.final,
                result.peak_current);
    EXPECT_GT(result.worst, 0.05);
    EXPECT_LT(result.worst, belt().following_error_max / 5);
    EXPECT_LT(result.final, 2 * M_PI / belt().encoder_increments);
    EXPECT_LT(result.peak_current, belt().current_max);
  }
}

// friction at full speed and the steepest path that the EDP accepts, at once
TEST(ConveyorServo, DriveHasTheCurrentForItsLimits) {
  const double gear = conveyor_model()->transmission(one(0))(0, 0);
  const double friction = gear * belt().velocity_max * belt().viscous_friction / belt().torque_constant;
  const double inertia = gear * 1.5 * belt().acceleration_max * belt().rotor_inertia / belt().torque_constant;
  std::printf("friction %.1f A, acceleration %.1f A of %.0f A, %.0f rad/s\n", friction, inertia, belt().current_max,
              gear * belt().velocity_max);
  EXPECT_LT(friction + inertia, 0.95 * belt().current_max);
  EXPECT_LT(gear * belt().velocity_max, 250) << "the original's panic speed";
}

}  // namespace
}  // namespace mrroc
