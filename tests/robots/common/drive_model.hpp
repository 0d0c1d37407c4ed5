#pragma once

#include <algorithm>
#include <cmath>

#include "mrroc/robot_parameters.hpp"
#include "robots/common/servo.hpp"

namespace mrroc {

/// A drive's plant model (J + load) dw/dt = k i - b w, solved exactly between ticks.
struct DriveModel {
  double load = 0;      ///< inertia of the links at the shaft, kg m^2
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

/// A raised-cosine move of `length` rad in 2 s by `control`, which returns the current for a desired and an actual
/// shaft position; the current acts `delay` ticks (0 or 1) late.
template <class Control>
Tracking track(const AxisParameters& axis, DriveModel drive, double length, int delay, Control control) {
  constexpr double kDuration = 2;
  Tracking result;
  double last_current = 0;
  for (int tick = 1; tick <= 2000; ++tick) {
    const double t = std::min(tick * kServoPeriod, kDuration);
    const double desired = length * (1 - std::cos(M_PI * t / kDuration)) / 2;
    const double current = control(desired, drive.position);
    drive.step(axis, delay == 0 ? current : last_current);
    last_current = current;
    result.worst = std::max(result.worst, std::abs(desired - drive.position));
    result.final = std::abs(desired - drive.position);
    result.peak_current = std::max(result.peak_current, std::abs(current));
  }
  return result;
}

/// The same move of 20 rad by the original's servo law.
inline Tracking track_by_servo(const AxisParameters& axis, int delay, double load = 0) {
  AxisServo servo(axis, 0);
  return track(axis, {.load = load}, 20, delay,
               [&servo](double desired, double position) { return servo.current(desired, position); });
}

}  // namespace mrroc
