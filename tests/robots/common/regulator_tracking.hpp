#pragma once

#include <cmath>

#include "edp/servo/regulator.hpp"
#include "robots/common/drive_model.hpp"

namespace mrroc {

/// A raised-cosine move (see `track`) of `length` rad by the EDP's regulator on the drive's model, with its encoder.
inline Tracking track_by_regulator(const AxisParameters& axis, double length, int delay) {
  const double increment = 2 * M_PI / axis.encoder_increments;
  edp::Regulator regulator(axis);
  double last_desired = 0, last_reading = 0;
  return track(axis, {}, length, delay, [&](double desired, double position) {
    const double reading = increment * std::round(position / increment);
    const double current = regulator.step(desired - last_desired, reading - last_reading);
    last_desired = desired;
    last_reading = reading;
    return current;
  });
}

}  // namespace mrroc
