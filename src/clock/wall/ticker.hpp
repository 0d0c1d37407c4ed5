#pragma once

#include <atomic>
#include <cstdint>

#include "clock/wall/histogram.hpp"
#include "mrroc/types.hpp"

namespace mrroc::clock {

/// The real-time grid: lets one thread run once per servo period, tick k at epoch + k T of CLOCK_MONOTONIC, by absolute
/// sleeps. The grid is never re-phased. A tick whose whole period has passed before its thread could begin it is
/// missed: it is counted but not returned. So the returned tick is always the present one of the wall clock.
///
/// For EDP servo threads and, in real time, the simulator. `wait_next` is called by that one thread and neither
/// allocates nor locks; any thread may read the statistics.
class Ticker {
 public:
  /// `epoch_ns` as `Clock::epoch_ns()`, `period_ns` > 0. Made after the epoch it begins with the next tick to come.
  Ticker(std::int64_t epoch_ns, std::int64_t period_ns) noexcept;

  /// Sleeps until the tick after the last one returned and returns its number; returns at once, with the present tick,
  /// when that one has begun already.
  Tick wait_next() noexcept;

  /// Ticks returned, ticks missed.
  std::uint64_t ticks() const noexcept { return lateness_.count(); }
  std::uint64_t missed() const noexcept { return missed_.load(std::memory_order_relaxed); }
  /// From a tick's time on the grid to the return of `wait_next`, ns.
  const Histogram& lateness() const noexcept { return lateness_; }
  /// From the return of `wait_next` to the next call of it, ns.
  const Histogram& execution() const noexcept { return execution_; }

 private:
  std::int64_t begin_of(Tick tick) const noexcept { return epoch_ns_ + static_cast<std::int64_t>(tick) * period_ns_; }

  std::int64_t epoch_ns_;
  std::int64_t period_ns_;
  Tick next_;
  std::int64_t woken_ns_ = 0;  // 0: no tick has been returned
  std::atomic<std::uint64_t> missed_{0};
  Histogram lateness_;
  Histogram execution_;
};

}  // namespace mrroc::clock
