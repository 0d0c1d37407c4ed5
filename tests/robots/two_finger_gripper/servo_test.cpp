#include <gtest/gtest.h>

#include "gripper_fixture.hpp"
#include "robots/common/regulator_tracking.hpp"

namespace mrroc::servo_test {
namespace {

TEST(GripperServo, OriginalLawTracksAlsoWithATickOfDelay) {
  for (const int delay : {0, 1}) {
    const Tracking result = track_by_regulator(opening_axis(), 400, delay);  // 314 rad/s at most
    std::printf("delay %d: worst %.2f rad (%.3f mm of a cube of 57 mm), final %.1e rad, peak %.1f mA\n", delay,
                result.worst, 1000 * result.worst / 49793, result.final, 1000 * result.peak_current);
    EXPECT_GT(result.worst, 0.2);
    EXPECT_LT(result.worst, opening_axis().following_error_max / 100);
    EXPECT_LT(result.final, 2 * M_PI / opening_axis().encoder_increments);
    EXPECT_LT(result.peak_current, opening_axis().regulator_output_max * opening_axis().regulator_current_gain + 1e-9);
  }
}

}  // namespace
}  // namespace mrroc::servo_test
