#pragma once

#include <cstdint>

#include "clock/wall/monotonic.hpp"

namespace mrroc::clock {

/// Waits for a partner for `timeout` ns in slices: calls `wait(deadline)` (CLOCK_MONOTONIC, ns) until it returns true.
/// A machine that stands still for longer than the timeout loses one slice, so the partner has the others to answer.
/// False: it has not. The calling thread.
template <class Wait>
bool wait_in_slices(std::int64_t timeout, Wait wait) noexcept {
  constexpr std::int64_t kSlice = kSecond / 2;
  for (std::int64_t waited = 0; waited < timeout; waited += kSlice)
    if (wait(monotonic_ns() + kSlice)) return true;
  return false;
}

}  // namespace mrroc::clock
