#pragma once

#include "mrroc/types.hpp"

namespace mrroc::vsp {

/// First-order low-pass of a wrench, the exact response to an input that changes at ticks and holds between them:
///
///     y_k = y_j + (1 - exp(-2 pi f (k - j) T)) (u_k - y_j)
///
/// f: cut-off (-3 dB), Hz; T: servo period, s; j: the tick of the update before. The first update gives y = u. f = 0:
/// y = u always. It delays slow changes by `delay()`. Allocates nothing, never throws.
class LowPass {
 public:
  /// Also begins again: the next update gives y = u.
  void configure(double cutoff, double servo_period) noexcept;
  bool enabled() const noexcept { return rate_ > 0; }
  /// Group delay at frequency 0, s: how far y lags behind a ramp, updated at every tick. T / (exp(2 pi f T) - 1), for f
  /// well below the servo rate that is 1 / (2 pi f) - T / 2; 0 without a filter.
  double delay() const noexcept;
  /// An update at the same tick as the last, or before it, changes nothing.
  void update(Tick tick, const Wrench& u) noexcept;
  /// Adds `change` to u as if it had always been part of it: y changes by the same at once.
  void shift(const Wrench& change) noexcept { y_ += change; }
  const Wrench& value() const noexcept { return y_; }
  /// False before the first update.
  bool started() const noexcept { return started_; }

 private:
  double rate_ = 0;  ///< 2 pi f T, per tick
  double servo_period_ = 0;
  bool started_ = false;
  Tick tick_ = 0;
  Wrench y_ = Wrench::Zero();
};

}  // namespace mrroc::vsp
