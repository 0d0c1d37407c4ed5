#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

#include "mrroc/types.hpp"

namespace mrroc::clock {

/// Which robots of one computer have stopped in the middle of a motion that they share with others (CommonStop::group),
/// in the clock's memory: every servo writes its own entry and checks those of the others in each tick, so that a group
/// stops without a message. A stop counts from the next tick on, so under lockstep it does not matter which servo runs
/// first. Any process; never waits.
class GroupStops {
 public:
  static constexpr std::size_t kMaxRobots = 64;

  /// Robot `robot` of the deployment stops in `tick`; one from kMaxRobots on does so alone. Its servo's thread.
  void announce(std::size_t robot, std::uint64_t group, Tick tick) noexcept {
    if (robot >= kMaxRobots) return;
    Entry& entry = entries_[robot];
    if (entry.group.load(std::memory_order_relaxed) == group) return;  // its first stop counts
    entry.group.store(0, std::memory_order_relaxed);
    entry.tick.store(tick, std::memory_order_release);
    entry.group.store(group, std::memory_order_release);
  }

  /// Whether a robot of `group` has stopped before `tick`. Any thread.
  bool has_stopped(std::uint64_t group, Tick tick) const noexcept {
    for (const Entry& entry : entries_)
      if (entry.group.load(std::memory_order_acquire) == group && entry.tick.load(std::memory_order_relaxed) < tick)
        return true;
    return false;
  }

 private:
  struct alignas(64) Entry {
    std::atomic<std::uint64_t> group{0};
    std::atomic<Tick> tick{0};
  };
  std::array<Entry, kMaxRobots> entries_;
};

}  // namespace mrroc::clock
