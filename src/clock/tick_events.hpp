#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <vector>

#include "mrroc/types.hpp"

namespace mrroc::clock {

/// Events at given ticks: the operator's commands and injected faults of a script. Any thread.
class TickEvents {
 public:
  /// `tick`: the one that begins, from which the callback's effects are visible.
  using Callback = std::function<void(Tick tick)>;

  void add(Tick tick, Callback callback) {
    const std::scoped_lock lock(mutex_);
    events_.emplace(tick, std::move(callback));
  }
  /// Tick of the first event; kNever when there is none.
  Tick next() const {
    const std::scoped_lock lock(mutex_);
    return events_.empty() ? kNever : events_.begin()->first;
  }
  /// Removes and runs all events up to and including `tick`: by tick, then in the order in which they were added.
  void run(Tick tick) {
    std::vector<Callback> due;
    {
      const std::scoped_lock lock(mutex_);
      const auto end = events_.upper_bound(tick);
      for (auto event = events_.begin(); event != end; ++event) due.push_back(std::move(event->second));
      events_.erase(events_.begin(), end);
    }
    for (const Callback& callback : due) callback(tick);
  }

 private:
  mutable std::mutex mutex_;
  std::multimap<Tick, Callback> events_;
};

}  // namespace mrroc::clock
