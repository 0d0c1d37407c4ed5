#include "clock/gate.hpp"

#include <linux/futex.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <climits>

namespace mrroc::clock {

void Gate::open() noexcept {
  word_.fetch_add(kOpening);
  wake();
}

void Gate::interrupt() noexcept {
  word_.fetch_or(kInterrupted);
  wake();
}

bool Gate::sleep(std::uint32_t seen, std::int64_t deadline_ns) noexcept {
  const timespec deadline = to_timespec(deadline_ns);
  while (word() == seen) {
    if (deadline_ns != kForever && monotonic_ns() >= deadline_ns) return false;
    // BITSET: the timeout is absolute, on CLOCK_MONOTONIC; a signal or a spurious wake-up loops
    ::syscall(SYS_futex, &word_, FUTEX_WAIT_BITSET, seen, deadline_ns == kForever ? nullptr : &deadline, nullptr,
              FUTEX_BITSET_MATCH_ANY);
  }
  return true;
}

void Gate::wake() noexcept { ::syscall(SYS_futex, &word_, FUTEX_WAKE, INT_MAX, nullptr, nullptr, 0); }

}  // namespace mrroc::clock
