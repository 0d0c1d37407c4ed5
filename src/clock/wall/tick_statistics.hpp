#pragma once

#include <atomic>
#include <cstdint>

#include "clock/wall/histogram.hpp"

namespace mrroc::clock {

/// When the ticks of one thread began and how long they took. No allocation, no lock. That thread calls `begin` and
/// `end`, any thread reads.
class TickStatistics {
 public:
  /// A tick begins at `now`, `lateness` after its time on the grid (ns), and after `missed` others that did not.
  void begin(std::int64_t now, std::int64_t lateness, std::uint64_t missed) noexcept {
    begun_ = now;
    lateness_.add(lateness);
    missed_.store(this->missed() + missed, std::memory_order_relaxed);
  }
  /// It has ended; without a `begin` before nothing has.
  void end(std::int64_t now) noexcept {
    if (begun_ != 0) execution_.add(now - begun_);
  }

  /// Ticks begun, ticks missed.
  std::uint64_t ticks() const noexcept { return lateness_.count(); }
  std::uint64_t missed() const noexcept { return missed_.load(std::memory_order_relaxed); }
  /// From a tick's time on the grid to its begin, ns.
  const Histogram& lateness() const noexcept { return lateness_; }
  /// From the begin of a tick to its end, ns.
  const Histogram& execution() const noexcept { return execution_; }

 private:
  std::int64_t begun_ = 0;
  std::atomic<std::uint64_t> missed_{0};
  Histogram lateness_;
  Histogram execution_;
};

}  // namespace mrroc::clock
