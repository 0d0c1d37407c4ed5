#pragma once

#include <cstdint>

#include "clock/clock.hpp"
#include "clock/clock_memory.hpp"

namespace mrroc::clock {

/// What every process's clock has in common: its slot of the clock's memory, on whose gate its thread sleeps.
class ParticipantClock : public Clock {
 public:
  /// Takes part as slot `index` of `memory`. Throws SystemError when the host has died already.
  ParticipantClock(MappedClock memory, std::uint32_t index);
  /// Leaves: from now on nobody waits for this process.
  ~ParticipantClock() override;

  double period() const noexcept override;
  double wall_seconds() const noexcept override;
  std::int64_t epoch_ns() const noexcept override;
  bool stopping() const noexcept override { return memory_->stop_tick.load() != kNever; }
  void interrupt() noexcept override;
  Tick fault_tick(std::size_t index) const noexcept override { return memory_->fault_ticks[index].load(); }
  void set_off_fault(std::size_t index, Tick tick) noexcept override { clock::set_off_fault(*memory_, index, tick); }
  EmergencyStop& emergency_stop() noexcept override { return memory_->emergency_stop; }

 protected:
  ClockMemory& memory() const noexcept { return *memory_; }
  ParticipantSlot& slot() const noexcept { return memory_->participants[index_]; }
  std::uint32_t index() const noexcept { return index_; }

  /// Says "ready" to the host.
  void announce_ready() noexcept;
  /// Sleeps until the host has started the clock. False: interrupted; the process has left.
  bool await_start() noexcept;
  /// Sleeps until the slot's gate differs from `seen` or the deadline comes. False: interrupted, failed, ended, or the
  /// host has died or, under a clock of wall time, shown no life for kPatienceWithHost; the process has left.
  bool sleep(std::uint32_t seen, std::int64_t deadline_ns) noexcept;
  void leave() noexcept;
  /// Under a clock of wall time, at every wait: interrupts when the host has died or is silent, at most a second after.
  /// Messages that flow on keep `sleep` from asking.
  void look_for_host() noexcept;

 private:
  bool host_alive() const noexcept;

  MappedClock memory_;
  std::uint32_t index_;
  int host_process_;               // pidfd
  std::int64_t next_look_ns_ = 0;  // for the host; the participant's thread
};

}  // namespace mrroc::clock
