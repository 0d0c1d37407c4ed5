#include <gtest/gtest.h>

#include <cmath>

#include "edp/regulator.hpp"
#include "fixture.hpp"

namespace mrroc {
namespace {

constexpr double kPeriod = 0.002;  // s

/// A drive's plant model J dw/dt = k i - b w, solved exactly between ticks.
struct Drive {
  double position = 0;  ///< rad of the shaft
  double speed = 0;     ///< rad/s

  void step(const AxisParameters& axis, double current) {
    const double end_speed = axis.torque_constant * current / axis.viscous_friction;
    const double time_constant = axis.rotor_inertia / axis.viscous_friction;
    const double rest = std::exp(-kPeriod / time_constant);
    position += end_speed * kPeriod + (speed - end_speed) * time_constant * (1 - rest);
    speed = end_speed + (speed - end_speed) * rest;
  }
};

struct Tracking {
  double worst = 0;         ///< rad of the shaft, during the move
  double final = 0;         ///< rad of the shaft, two seconds after it
  double peak_current = 0;  ///< A
};

/// A raised-cosine move of `length` rad in 2 s, by encoder increments; the current acts `delay` ticks (0 or 1) late.
Tracking track(const AxisParameters& axis, double length, int delay) {
  constexpr double kDuration = 2;
  const double increment = 2 * M_PI / axis.encoder_increments;
  edp::Regulator regulator(axis);
  Drive drive;
  Tracking result;
  double last_current = 0, last_desired = 0, last_measured = 0;
  for (int tick = 1; tick <= 2000; ++tick) {
    const double desired = length * (1 - std::cos(M_PI * std::min(tick * kPeriod / kDuration, 1.0))) / 2;
    const double measured = std::round(drive.position / increment) * increment;
    const double current = regulator.step(desired - last_desired, measured - last_measured);
    last_desired = desired;
    last_measured = measured;
    drive.step(axis, delay == 0 ? current : last_current);
    last_current = current;
    result.worst = std::max(result.worst, std::abs(desired - drive.position));
    result.final = std::abs(desired - drive.position);
    result.peak_current = std::max(result.peak_current, std::abs(current));
  }
  return result;
}

// a simulator or a bus with a clock of its own acts up to one tick late
TEST(SerialParallelServo, EveryAxisTracksARaisedCosineAlsoATickLate) {
  for (const AxisParameters& axis : machine().parameters().axes) {
    for (const int delay : {0, 1}) {
      const Tracking result = track(axis, 20, delay);
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
    const Tracking result = track(axis, speed * 4 / M_PI, 1);
    std::printf("%-10s at %.0f rad/s: worst %.3f rad, peak %.3f A\n", axis.name.c_str(), speed, result.worst,
                result.peak_current);
    EXPECT_LT(result.worst, axis.following_error_max / 2) << axis.name;
    EXPECT_LT(result.peak_current, axis.regulator_output_max * axis.regulator_current_gain) << axis.name;
  }
}

}  // namespace
}  // namespace mrroc
