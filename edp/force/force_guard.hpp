#pragma once

#include <algorithm>
#include <cmath>

#include "edp/force/force_sensor.hpp"

namespace mrroc::edp {

/// Watches the wrench that a robot meets. A robot that has been stopped by it stands in contact and has to come out of
/// it: what it met then is allowed from there on, plus a tenth, and shrinks with the force, down to the limit. So it
/// may go back, and goes no farther in. Allocates nothing, never throws.
class ForceGuard {
 public:
  explicit ForceGuard(const ForceLimits& limits) noexcept : limits_(limits), allowed_(limits) {}

  /// Takes the wrench of a tick. `moving`: the robot follows a plan; else it rests, or stops already, and whatever it
  /// meets is allowed. The axis (0..5) that is beyond what is allowed, -1: none. NaN is beyond.
  int look(const Wrench& wrench, bool moving) noexcept {
    int beyond = -1;
    for (int i = 5; i >= 0; --i) {
      const double met = std::abs(wrench[i]);
      if (moving && !(met <= allowed_[i])) beyond = i;
      const double wanted = std::max(limits_[i], kMargin * met);
      allowed_[i] = moving ? std::min(allowed_[i], wanted) : wanted;
    }
    return beyond;
  }
  double limit(int axis) const noexcept { return limits_[axis]; }

 private:
  static constexpr double kMargin = 1.1;
  ForceLimits limits_;
  Wrench allowed_;
};

}  // namespace mrroc::edp
