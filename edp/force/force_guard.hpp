#pragma once

#include <algorithm>
#include <cmath>

#include "edp/force/force_sensor.hpp"

namespace mrroc::edp {

/// Watches the contact wrench of a robot. A robot that it has stopped is in contact and must be able to leave it: from
/// then on the wrench at the stop plus a tenth is allowed, and this bound shrinks with the force, down to the limit. So
/// the robot may go back, but not farther in. A set-point that is not farther in may meet more force: the arm follows
/// it late. A rest shorter than kRested ticks is that of a motion which stops at the end of each macrostep: it changes
/// no bound. Allocates nothing, never throws.
class ForceGuard {
 public:
  explicit ForceGuard(const ForceLimits& limits) noexcept : limits_(limits), allowed_(limits) {}

  /// Takes the wrench of a tick. `moving`: the robot follows a plan; else it rests or is stopping, and every wrench is
  /// allowed. `farther_in`: than at such a rest; else an axis that is leaving() may meet more. Returns the axis (0..5)
  /// beyond its bound, or -1. NaN is beyond.
  int check(const Wrench& wrench, bool moving, bool farther_in) noexcept {
    rested_ = moving ? 0 : std::min(rested_ + 1, kRested);
    int beyond = -1;
    for (int i = 5; i >= 0; --i) {
      const double met = std::abs(wrench[i]);
      const bool follows = allowed_[i] > limits_[i] && !farther_in;
      if (moving && !(follows ? std::isfinite(met) : met <= allowed_[i])) beyond = i;
      const double wanted = std::max(limits_[i], kMargin * met);
      allowed_[i] = rested_ == kRested || follows ? wanted : std::min(allowed_[i], wanted);
    }
    return beyond;
  }
  double limit(int axis) const noexcept { return limits_[axis]; }
  /// Whether more than the limits is allowed, of an axis at least.
  bool leaving() const noexcept { return (allowed_.array() > limits_.array()).any(); }

 private:
  static constexpr double kMargin = 1.1;
  static constexpr int kRested = 3;
  ForceLimits limits_;
  Wrench allowed_;
  int rested_ = kRested;  ///< ticks without a motion
};

}  // namespace mrroc::edp
