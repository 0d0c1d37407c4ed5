#pragma once

#include <poll.h>

#include <cstdint>

#include "clock/wall/monotonic.hpp"

namespace mrroc::can {

/// Waits until `descriptor` is readable (true) or `deadline` (CLOCK_MONOTONIC, ns) has passed (false). Never throws.
inline bool wait_readable(int descriptor, std::int64_t deadline) noexcept {
  pollfd entry{descriptor, POLLIN, 0};
  for (;;) {
    const std::int64_t left = deadline - clock::monotonic_ns();
    if (left <= 0) return false;
    const timespec time = clock::to_timespec(left);
    const int ready = ::ppoll(&entry, 1, deadline == clock::kForever ? nullptr : &time, nullptr);
    if (ready > 0) return true;
    if (ready == 0) return false;
  }
}

}  // namespace mrroc::can
