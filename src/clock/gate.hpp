#pragma once

#include <atomic>
#include <cstdint>

#include "clock/wall/monotonic.hpp"

namespace mrroc::clock {

/// Threads sleep on a gate, and any thread or process opens it: one futex word in shared memory. Bit 0 means
/// "interrupted" and stays set; the other bits count openings. Because a sleeper compares the whole word, no opening or
/// interruption between its last check and its sleep is lost. Zeroed memory is a valid gate.
class Gate {
 public:
  /// Read it before checking for work, and pass it to `sleep` when there is no work. Any thread.
  std::uint32_t word() const noexcept { return word_.load(); }
  /// Any thread.
  bool interrupted() const noexcept { return (word() & kInterrupted) != 0; }
  /// Number of openings in a word, modulo 2^31.
  static std::uint32_t openings(std::uint32_t word) noexcept { return word >> 1; }

  /// Wakes the sleeper. Any thread; one atomic add and a futex wake.
  void open() noexcept;
  /// Wakes the sleeper, now and whenever it tries to sleep again. Any thread, signal handlers too.
  void interrupt() noexcept;
  /// Sleeps until the word differs from `seen` (true) or CLOCK_MONOTONIC reaches `deadline_ns` (false).
  bool sleep(std::uint32_t seen, std::int64_t deadline_ns) noexcept;
  /// Sleeps until `ready()` holds, called at once and after every opening (true), or `duration_ns` have passed (false).
  /// Several threads or processes may wait at one gate.
  template <class Ready>
  bool wait(Ready ready, std::int64_t duration_ns) noexcept {
    const std::int64_t deadline_ns = monotonic_ns() + duration_ns;
    for (;;) {
      const std::uint32_t seen = word();
      if (ready()) return true;
      if (!sleep(seen, deadline_ns)) return ready();
    }
  }

 private:
  static constexpr std::uint32_t kInterrupted = 1;
  static constexpr std::uint32_t kOpening = 2;
  void wake() noexcept;

  std::atomic<std::uint32_t> word_{0};
  static_assert(std::atomic<std::uint32_t>::is_always_lock_free);
};

}  // namespace mrroc::clock
