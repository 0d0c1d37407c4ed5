#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "clock/wall/monotonic.hpp"
#include "mrroc/types.hpp"

/// Lockstep with a stand-in of a controller: the timestamp of a package is the time at which its tick begins.
namespace mrroc::ur {

/// Wall time after which a stand-in that sends no package is lost, ns.
inline constexpr std::int64_t kLockstepTimeout = 10 * clock::kSecond;
/// The timeout of connections and answers in lockstep, s.
inline constexpr double kLockstepAnswerTimeout = 60;

/// Ticks from one package to the next. `frequency` of the packages, Hz; `period` of the servo, s.
inline Tick package_ticks(double frequency, double period) noexcept {
  return static_cast<Tick>(std::max(std::lround(1 / (frequency * period)), 1L));
}

/// The tick of a package.
inline Tick tick_of_package(double timestamp, double period) noexcept {
  return static_cast<Tick>(std::max(std::llround(timestamp / period), 0LL));
}

}  // namespace mrroc::ur
