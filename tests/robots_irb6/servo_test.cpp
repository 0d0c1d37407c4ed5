#include "robots_irb6/servo.hpp"

#include <gtest/gtest.h>

#include "irb6_fixture.hpp"

namespace mrroc {
namespace {

/// A drive's plant model J dw/dt = k i - b w, solved exactly between ticks.
struct Drive {
  double position = 0;  ///< rad of the shaft
  double speed = 0;     ///< rad/s

  void step(const AxisParameters& axis, double current) {
    const double end_speed = axis.torque_constant * current / axis.viscous_friction;
    const double time_constant = axis.rotor_inertia / axis.viscous_friction;
    const double rest = std::exp(-kServoPeriod / time_constant);
    position += end_speed * kServoPeriod + (speed - end_speed) * time_constant * (1 - rest);
    speed = end_speed + (speed - end_speed) * rest;
  }
};

struct Tracking {
  double worst = 0;         ///< rad of the shaft, during the move
  double final = 0;         ///< rad of the shaft, two seconds after it
  double peak_current = 0;  ///< A
};

/// A raised-cosine move of 20 rad in 2 s; the current acts `delay` ticks (0 or 1) late.
Tracking track(const AxisParameters& axis, int delay) {
  constexpr double kLength = 20, kDuration = 2;
  AxisServo servo(axis, 0);
  Drive drive;
  Tracking result;
  double last_current = 0;
  for (int tick = 1; tick <= 2000; ++tick) {
    const double t = std::min(tick * kServoPeriod, kDuration);
    const double desired = kLength * (1 - std::cos(M_PI * t / kDuration)) / 2;
    const double current = servo.current(desired, drive.position);
    drive.step(axis, delay == 0 ? current : last_current);
    last_current = current;
    result.worst = std::max(result.worst, std::abs(desired - drive.position));
    result.final = std::abs(desired - drive.position);
    result.peak_current = std::max(result.peak_current, std::abs(current));
  }
  return result;
}

// expected of the original's numbers: tracking error 0.03 to 0.08 rad, peak 3 A, wrist 0.03 A without quantisation
TEST(Irb6Servo, TheOriginalsLawTracksARaisedCosineOnTheDrivesModel) {
  for (const AxisParameters& axis : irb6_model().parameters().axes) {
    const Tracking result = track(axis, 0);
    std::printf("%-12s worst %.3f rad, final %.1e rad, peak %.3f A\n", axis.name.c_str(), result.worst, result.final,
                result.peak_current);
    EXPECT_GT(result.worst, 0.02) << axis.name;
    EXPECT_LT(result.worst, 0.1) << axis.name;
    EXPECT_LT(result.final, 2 * M_PI / axis.encoder_increments) << axis.name;
    EXPECT_LT(result.peak_current, axis.viscous_friction > 1e-3 ? 4 : 0.1) << axis.name;
    EXPECT_LT(result.worst, axis.following_error_max / 10) << axis.name;
  }
}

// a simulator or a bus with a clock of its own acts up to one tick late
TEST(Irb6Servo, EveryAxisBearsATickOfDelay) {
  for (const AxisParameters& axis : irb6_model().parameters().axes) {
    const Tracking result = track(axis, 1);
    EXPECT_LT(result.worst, 0.1) << axis.name;
    EXPECT_LT(result.final, 2 * 2 * M_PI / axis.encoder_increments) << axis.name;
  }
}

TEST(Irb6Servo, TheWristRollsFullGainDoesNotBearATickOfDelay) {
  AxisParameters axis = irb6_model().parameters().axes[4];
  ASSERT_EQ(axis.name, "wrist_roll");
  axis.regulator_current_gain = 0.110;
  EXPECT_GT(track(axis, 1).final, 0.1) << "the reason for the reduced gain is gone";
}

}  // namespace
}  // namespace mrroc
