#pragma once

#include <algorithm>
#include <numbers>

#include "mrroc/robot_parameters.hpp"

namespace mrroc::edp {

/// The original's servo law of one axis (algorithm 0), once per servo period. With r the commanded and y the measured
/// increment of the shaft in encoder counts, ' one tick and '' two ticks ago:
///   e = e' + (1 + eps) (r - y) - (1 - eps) (r' - y')
///   u = (1 + a) u' - a u'' + b0 e - b1 e',  held within +-output_max
/// e is the velocity error plus 2 eps times its sum, so a position error does not stay; u, the original's PWM, becomes
/// the motor current i = gain u, held within +-current_max. The fed back u is the one that was put out (no wind-up).
/// Allocates nothing, never throws. The owner's thread.
class Regulator {
 public:
  explicit Regulator(const AxisParameters& axis) noexcept { take(axis); }

  /// From now on with the numbers of `axis`. The motor current continues as it was.
  void use(const AxisParameters& axis) noexcept {
    const double scale = gain_ / axis.regulator_current_gain;
    take(axis);
    output_ = std::clamp(scale * output_, -output_max_, output_max_);
    previous_output_ = std::clamp(scale * previous_output_, -output_max_, output_max_);
  }

  /// Forgets the past: the drive has just been switched on at rest.
  void reset() noexcept { difference_ = error_ = output_ = previous_output_ = 0; }

  /// Increments of the shaft since the last tick, rad. Returns the current for the coming period, A.
  double step(double commanded, double measured) noexcept {
    const double difference = (commanded - measured) * counts_per_rad_;
    const double error = error_ + (1.0 + eps_) * difference - (1.0 - eps_) * difference_;
    const double output = std::clamp((1.0 + a_) * output_ - a_ * previous_output_ + b0_ * error - b1_ * error_,
                                     -output_max_, output_max_);
    difference_ = difference;
    error_ = error;
    previous_output_ = output_;
    output_ = output;
    return std::clamp(gain_ * output, -current_max_, current_max_);
  }

 private:
  void take(const AxisParameters& axis) noexcept {
    counts_per_rad_ = axis.encoder_increments / (2.0 * std::numbers::pi);
    a_ = axis.regulator_a;
    b0_ = axis.regulator_b0;
    b1_ = axis.regulator_b1;
    eps_ = axis.regulator_eps;
    output_max_ = axis.regulator_output_max;
    gain_ = axis.regulator_current_gain;
    current_max_ = axis.current_max;
  }

  double counts_per_rad_ = 0, a_ = 0, b0_ = 0, b1_ = 0, eps_ = 0, output_max_ = 0, gain_ = 0, current_max_ = 0;
  double difference_ = 0, error_ = 0, output_ = 0, previous_output_ = 0;
};

}  // namespace mrroc::edp
