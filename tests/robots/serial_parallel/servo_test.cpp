#include <gtest/gtest.h>

#include <cmath>

#include "fixture.hpp"
#include "robots/common/regulator_tracking.hpp"

namespace mrroc::servo_test {
namespace {

// a simulator or a bus with its own clock acts up to one tick late
TEST(SerialParallelServo, EveryAxisTracksARaisedCosineAlsoATickLate) {
  for (const AxisParameters& axis : machine().parameters().axes) {
    for (const int delay : {0, 1}) {
      const Tracking result = track_by_regulator(axis, 20, delay);
      std::printf("%-10s %d ticks late: worst %.3f rad, final %.1e rad, peak %.3f A\n", axis.name.c_str(), delay,
                  result.worst, result.final, result.peak_current);
      EXPECT_GT(result.worst, 0.005) << axis.name;
      EXPECT_LT(result.worst, axis.following_error_max / 3) << axis.name;
      EXPECT_LT(result.final, 2 * 2 * M_PI / axis.encoder_increments) << axis.name;
      EXPECT_LT(result.peak_current, axis.current_max / 2) << axis.name;
    }
  }
}

// the raised cosine of 2 s that reaches the axis' full speed
TEST(SerialParallelServo, EveryAxisFollowsAtFullSpeed) {
  for (std::size_t i = 0; i < 6; ++i) {
    const AxisParameters& axis = machine().parameters().axes[i];
    const double speed = std::abs(geometry().gears[static_cast<Eigen::Index>(i)]) * axis.velocity_max;
    const Tracking result = track_by_regulator(axis, speed * 4 / M_PI, 1);
    std::printf("%-10s at %.0f rad/s: worst %.3f rad, peak %.3f A\n", axis.name.c_str(), speed, result.worst,
                result.peak_current);
    EXPECT_LT(result.worst, axis.following_error_max / 2) << axis.name;
    EXPECT_LT(result.peak_current, axis.regulator_output_max * axis.regulator_current_gain) << axis.name;
  }
}

}  // namespace
}  // namespace mrroc::servo_test
