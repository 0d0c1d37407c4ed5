#pragma once

#include <algorithm>
#include <cmath>

#include "mrroc/robot_parameters.hpp"

namespace mrroc {

/// Period of the original's servo, s.
inline constexpr double kServoPeriod = 0.002;

/// One axis under the original's servo law (algorithm 0), for the tests' own small simulations: encoder increments in,
/// motor current out. e = e' + (1 + eps)(r - y) - (1 - eps)(r' - y'); u = (1 + a) u' - a u'' + b0 e - b1 e'.
class AxisServo {
 public:
  AxisServo(const AxisParameters& axis, double start) : axis_(axis), desired_(start), measured_(encoder(start)) {}

  /// One tick: desired and true shaft position, rad. Returns the current, A.
  double current(double desired, double position) {
    const double counts_per_rad = axis_.encoder_increments / (2 * M_PI);
    const double reading = encoder(position);
    const double slip = (desired - desired_) * counts_per_rad - (reading - measured_);
    desired_ = desired;
    measured_ = reading;
    const double e = e1_ + (1 + axis_.regulator_eps) * slip - (1 - axis_.regulator_eps) * slip1_;
    const double u =
        (1 + axis_.regulator_a) * u1_ - axis_.regulator_a * u2_ + axis_.regulator_b0 * e - axis_.regulator_b1 * e1_;
    slip1_ = slip;
    e1_ = e;
    u2_ = u1_;
    u1_ = std::clamp(u, -axis_.regulator_output_max, axis_.regulator_output_max);
    return std::clamp(u1_ * axis_.regulator_current_gain, -axis_.current_max, axis_.current_max);
  }

 private:
  double encoder(double position) const { return std::round(position * axis_.encoder_increments / (2 * M_PI)); }

  AxisParameters axis_;
  double desired_, measured_;
  double slip1_ = 0, e1_ = 0, u1_ = 0, u2_ = 0;
};

}  // namespace mrroc
