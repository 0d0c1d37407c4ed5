#pragma once

#include <algorithm>
#include <cmath>

#include "edp/regulator.hpp"

namespace mrroc {

/// The period for which the regulators' gains are, s.
inline constexpr double kServoPeriod = 0.002;

/// A drive's plant model J dw/dt = k i - b w, solved exactly between ticks.
struct DriveModel {
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

/// The EDP's regulator on the drive's model, with its encoder, through a raised-cosine move of `length` rad in 2 s; the
/// current acts `delay` ticks (0 or 1) late.
inline Tracking track(const AxisParameters& axis, double length, int delay) {
  constexpr double kDuration = 2;
  const double increment = 2 * M_PI / axis.encoder_increments;
  edp::Regulator regulator(axis);
  DriveModel drive;
  Tracking result;
  double last_current = 0, last_desired = 0, last_reading = 0;
  for (int tick = 1; tick <= 2000; ++tick) {
    const double t = std::min(tick * kServoPeriod, kDuration);
    const double desired = length * (1 - std::cos(M_PI * t / kDuration)) / 2;
    const double reading = increment * std::round(drive.position / increment);
    const double current = regulator.step(desired - last_desired, reading - last_reading);
    last_desired = desired;
    last_reading = reading;
    drive.step(axis, delay == 0 ? current : last_current);
    last_current = current;
    result.worst = std::max(result.worst, std::abs(desired - drive.position));
    result.final = std::abs(desired - drive.position);
    result.peak_current = std::max(result.peak_current, std::abs(current));
  }
  return result;
}

}  // namespace mrroc
