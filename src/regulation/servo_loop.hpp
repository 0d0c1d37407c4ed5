#pragma once

#include <complex>

#include "mrroc/robot_parameters.hpp"

namespace mrroc::regulation {

/// How far a servo loop is from instability.
struct LoopMargins {
  bool stable = false;
  double crossover = 0;      ///< Hz, where the open loop's gain is 1; of several the highest
  double phase_margin = 0;   ///< rad, the smallest at a crossover
  double gain_increase = 0;  ///< factor by which the gain may grow, as with a smaller inertia; infinite: any
  double gain_decrease = 0;  ///< factor to which it may sink, as with a larger inertia; 0: to any
};

/// The loop of one axis' shaft, linear and in discrete time: the servo law of the EDP (algorithm 0,
/// edp/servo/regulator.hpp) with the axis' numbers, one period of delay, and the motor with what it turns:
///   J d2y/dt2 = k i - B dy/dt,   y sampled every period, i constant within it
///   L(z) = C(z) P(z) z^-1,  C = c g (b0 - b1 z^-1) ((1 + eps) - (1 - eps) z^-1) / ((1 - z^-1)(1 - a z^-1))
/// with c counts per rad, g the current gain, k the torque constant. Limits of current and output are left out. Any
/// thread; the constructor never throws.
class ServoLoop {
 public:
  /// `inertia`: J, kg m2 at the shaft, of motor and load; `period`: s.
  ServoLoop(const AxisParameters& axis, double inertia, double period) noexcept;

  /// L at the angular frequency `rate`, rad/s, above 0 and below pi / period.
  std::complex<double> open(double rate) const noexcept;
  /// Computed from 20,000 frequencies; allocates.
  LoopMargins margins() const;

 private:
  bool stable() const;

  double period_, gain_, a_, b0_, b1_, eps_;
  double decay_, near_, far_;  ///< P = (near z^-1 + far z^-2) / ((1 - z^-1)(1 - decay z^-1))
};

}  // namespace mrroc::regulation
