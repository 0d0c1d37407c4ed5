#include "robots_common/servo.hpp"

#include <gtest/gtest.h>

#include "robots_polycrank/polycrank_fixture.hpp"

namespace mrroc {
namespace {

/// A drive's plant model J dw/dt = k i - b w, solved exactly between ticks. `load`: inertia of the links at the shaft.
struct Drive {
  double load = 0;      ///< kg m^2
  double position = 0;  ///< rad of the shaft
  double speed = 0;     ///< rad/s

  void step(const AxisParameters& axis, double current) {
    const double end_speed = axis.torque_constant * current / axis.viscous_friction;
    const double time_constant = (axis.rotor_inertia + load) / axis.viscous_friction;
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
Tracking track(const AxisParameters& axis, double load, int delay) {
  constexpr double kLength = 20, kDuration = 2;
  AxisServo servo(axis, 0);
  Drive drive{.load = load};
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

// the links' inertia at the shafts is up to three times that of the rotors (gravity_test)
TEST(PolycrankServo, TracksARaisedCosineOnTheDrivesModelWithAndWithoutTheLinks) {
  for (const AxisParameters& axis : polycrank_model().parameters().axes) {
    for (const double load : {0.0, 3 * axis.rotor_inertia}) {
      const Tracking result = track(axis, load, 0);
      std::printf("%-9s load %.1e kg m^2: worst %.3f rad, final %.1e rad, peak %.3f A\n", axis.name.c_str(), load,
                  result.worst, result.final, result.peak_current);
      EXPECT_GT(result.worst, 0.02) << axis.name;
      EXPECT_LT(result.worst, 0.12) << axis.name;
      EXPECT_LT(result.final, 2 * M_PI / axis.encoder_increments) << axis.name;
      EXPECT_LT(result.peak_current, axis.current_max / 3) << axis.name;
    }
  }
}

// a simulator or a bus with a clock of its own acts up to one tick late
TEST(PolycrankServo, EveryAxisBearsATickOfDelay) {
  for (const AxisParameters& axis : polycrank_model().parameters().axes) {
    for (const double load : {0.0, 3 * axis.rotor_inertia}) {
      const Tracking result = track(axis, load, 1);
      EXPECT_LT(result.worst, 0.12) << axis.name << ' ' << load;
      EXPECT_LT(result.final, 2 * 2 * M_PI / axis.encoder_increments) << axis.name << ' ' << load;
    }
  }
}

}  // namespace
}  // namespace mrroc
