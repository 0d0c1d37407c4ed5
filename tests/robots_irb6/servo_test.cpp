#include "robots_irb6/servo.hpp"

#include <gtest/gtest.h>

#include "irb6_fixture.hpp"

namespace mrroc {
namespace {

struct Tracking {
  double worst = 0;         ///< rad of the shaft, during the move
  double final = 0;         ///< rad of the shaft, two seconds after it
  double peak_current = 0;  ///< A
};

/// A raised-cosine move of 20 rad in 2 s on the drive's plant model J dw/dt = k i - b w, solved exactly between ticks.
/// (An explicit Euler step at the servo's period adds a tick of delay, and the wrist roll's loop is then unstable.)
Tracking track(const AxisParameters& axis) {
  constexpr double kLength = 20, kDuration = 2;
  AxisServo servo(axis, 0);
  Tracking result;
  double position = 0, speed = 0;
  for (int tick = 1; tick <= 2000; ++tick) {
    const double t = std::min(tick * kServoPeriod, kDuration);
    const double desired = kLength * (1 - std::cos(M_PI * t / kDuration)) / 2;
    const double current = servo.current(desired, position);
    const double end_speed = axis.torque_constant * current / axis.viscous_friction;
    const double time_constant = axis.rotor_inertia / axis.viscous_friction;
    const double rest = std::exp(-kServoPeriod / time_constant);
    position += end_speed * kServoPeriod + (speed - end_speed) * time_constant * (1 - rest);
    speed = end_speed + (speed - end_speed) * rest;
    result.worst = std::max(result.worst, std::abs(desired - position));
    result.final = std::abs(desired - position);
    result.peak_current = std::max(result.peak_current, std::abs(current));
  }
  return result;
}

// expected of the original's numbers: tracking error 0.03 to 0.08 rad, peak 3 A, wrist 0.03 A without quantisation
TEST(Irb6Servo, TheOriginalsGainsTrackARaisedCosineOnTheDrivesModel) {
  for (const AxisParameters& axis : irb6_model().parameters().axes) {
    const Tracking result = track(axis);
    std::printf("%-12s worst %.3f rad, final %.1e rad, peak %.3f A\n", axis.name.c_str(), result.worst, result.final,
                result.peak_current);
    EXPECT_GT(result.worst, 0.02) << axis.name;
    EXPECT_LT(result.worst, 0.1) << axis.name;
    EXPECT_LT(result.final, 2 * M_PI / axis.encoder_increments) << axis.name;
    EXPECT_LT(result.peak_current, axis.viscous_friction > 1e-3 ? 4 : 0.2) << axis.name;
    EXPECT_LT(result.worst, axis.following_error_max / 10) << axis.name;
  }
}

}  // namespace
}  // namespace mrroc
