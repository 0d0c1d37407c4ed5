#include <gtest/gtest.h>

#include "robots/common/drive_model.hpp"
#include "robots/irb6/family/robot_under_test.hpp"

namespace mrroc {
namespace {

// expected of the original's numbers: tracking error 0.03 to 0.08 rad, peak 3 A, wrist 0.03 A without quantisation
TEST(Servo, OriginalLawTracksARaisedCosineOnTheDrivesModel) {
  for (const AxisParameters& axis : robot().parameters().axes) {
    const Tracking result = track_by_servo(axis, 0);
    std::printf("%-12s worst %.3f rad, final %.1e rad, peak %.3f A\n", axis.name.c_str(), result.worst, result.final,
                result.peak_current);
    EXPECT_GT(result.worst, 0.02) << axis.name;
    EXPECT_LT(result.worst, 0.1) << axis.name;
    EXPECT_LT(result.final, 2 * M_PI / axis.encoder_increments) << axis.name;
    EXPECT_LT(result.peak_current, axis.current_max / 4) << axis.name;
    EXPECT_LT(result.worst, axis.following_error_max / 10) << axis.name;
  }
}

// a simulator or a bus with its own clock acts up to one tick late
TEST(Servo, EveryAxisToleratesATickOfDelay) {
  for (const AxisParameters& axis : robot().parameters().axes) {
    const Tracking result = track_by_servo(axis, 1);
    EXPECT_LT(result.worst, 0.1) << axis.name;
    EXPECT_LT(result.final, 2 * 2 * M_PI / axis.encoder_increments) << axis.name;
  }
}

}  // namespace
}  // namespace mrroc
