#pragma once

#include <poll.h>

#include <algorithm>
#include <cerrno>

#include "clock/wall/monotonic.hpp"

/// Waits of threads that talk to devices and other machines: never in lockstep's order of events, never in a servo
/// tick, but between two of a robot that keeps the time.
namespace mrroc::clock {

/// Sleeps for `ns`, or less after a signal. Any thread.
inline void pause(std::int64_t ns) noexcept {
  const timespec time = to_timespec(ns);
  ::nanosleep(&time, nullptr);
}

/// Waits until `fd` has one of the poll `events` or an error, or until `deadline` (CLOCK_MONOTONIC, ns); false: the
/// deadline came first. Any thread.
inline bool wait_for(int fd, short events, std::int64_t deadline) noexcept {
  for (;;) {
    const timespec limit = to_timespec(std::max<std::int64_t>(deadline - monotonic_ns(), 0));
    pollfd entry{fd, events, 0};
    const int ready = ::ppoll(&entry, 1, &limit, nullptr);
    if (ready == 0) return false;
    if (ready > 0 || errno != EINTR) return true;  // the next call on `fd` reports an error
  }
}

}  // namespace mrroc::clock
