#pragma once

#include <atomic>
#include <cstdint>

namespace mrroc::clock {

/// The operator's emergency stop of one deployment, in the clock's memory: every servo checks it in each tick, so that
/// a stop needs no message and no other process. Two counters that only grow: even a short press is never missed, and a
/// reader can recognise a reset after it. Any thread, any process, signal handlers too; never waits.
class EmergencyStop {
 public:
  /// Every robot of the deployment brakes, and stays stopped until it has been reset and recovered.
  void press() noexcept { presses_.fetch_add(1); }
  /// Releases the emergency stop; this does not move any robot.
  void reset() noexcept { resets_.fetch_add(1); }

  /// So far.
  std::uint32_t presses() const noexcept { return presses_.load(); }
  std::uint32_t resets() const noexcept { return resets_.load(); }

 private:
  std::atomic<std::uint32_t> presses_{0};
  std::atomic<std::uint32_t> resets_{0};
};

}  // namespace mrroc::clock
