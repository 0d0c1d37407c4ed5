#pragma once

#include "mrroc/time_scale.hpp"

/// The changes of the operator's speed from macrostep to macrostep. Any thread; never allocates or throws.
namespace mrroc {

/// Bounds of a change of the speed: its rate, 1/s, and the change of that rate, 1/s^2.
struct RampBounds {
  double rate = 0;
  double change = 0;
};

/// The time scale `duration` s after `from`, on the way to `wanted`: the rate is within the bounds, and becomes 0 when
/// the factor reaches `wanted`; it passes `wanted` only where the change has been too fast for that. `firmness`, 0..1:
/// the part of the bounds up to which the rate increases; it decreases within the whole bounds.
TimeScale ramp(TimeScale from, double wanted, double duration, RampBounds bounds, double firmness) noexcept;

/// The scale if the rate changes linearly to `rate` instead; the factor stays within 0..1.
TimeScale ramp_at_rate(TimeScale from, double duration, double rate) noexcept;

/// The own time, s, that passes in `duration` s of the clock's time, the factor being a cubic from `from` to `to`.
double own_time(TimeScale from, TimeScale to, double duration) noexcept;

}  // namespace mrroc
