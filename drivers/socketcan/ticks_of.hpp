#pragma once

#include <cmath>

#include "mrroc/types.hpp"

namespace mrroc::edp {

/// The least whole number of servo periods that is at least `time`; both in s.
inline Tick ticks_of(double time, double period) noexcept { return static_cast<Tick>(std::ceil(time / period)); }

}  // namespace mrroc::edp
