#pragma once

#include <cstdint>

#include "clock/wall/tick_statistics.hpp"
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

  /// A tick ends with the next call of `wait_next`. Any thread.
  const TickStatistics& statistics() const noexcept { return statistics_; }

 private:
  std::int64_t begin_of(Tick tick) const noexcept { return epoch_ns_ + static_cast<std::int64_t>(tick) * period_ns_; }

  std::int64_t epoch_ns_;
  std::int64_t period_ns_;
  Tick next_;
  TickStatistics statistics_;
};

}  // namespace mrroc::clock
