#pragma once

#include <cstdint>

#include "clock/clock.hpp"
#include "clock/clock_memory.hpp"
#include "clock/host_watch.hpp"

namespace mrroc::clock {

/// Common part of the processes' clocks: the slot of the clock's memory, on whose gate the process's thread sleeps.
class ParticipantClock : public Clock {
 public:
  /// Takes part as slot `index` of `memory`. Throws SystemError when the host has died already.
  ParticipantClock(MappedClock memory, std::uint32_t index);
  /// Leaves: from now on no process waits for this one.
  ~ParticipantClock() override;

  double period() const noexcept override;
  double wall_seconds() const noexcept override;
  std::int64_t epoch_ns() const noexcept override;
  bool stopping() const noexcept override { return memory_->stop_tick.load() != kNever; }
  void interrupt() noexcept override;
  Tick fault_tick(std::size_t index) const noexcept override { return memory_->fault_ticks[index].load(); }
  void set_off_fault(std::size_t index, Tick tick) noexcept override { clock::set_off_fault(*memory_, index, tick); }
  void end_task() noexcept override { clock::end_task(*memory_); }
  EmergencyStop& emergency_stop() noexcept override { return memory_->emergency_stop; }
  GroupStops& group_stops() noexcept override { return memory_->group_stops; }

 protected:
  ClockMemory& memory() const noexcept { return *memory_; }
  ParticipantSlot& slot() const noexcept { return memory_->participants[index_]; }
  std::uint32_t index() const noexcept { return index_; }

  /// Reports ready to the host.
  void announce_ready() noexcept;
  /// Sleeps until the host has started the clock. False: interrupted; the process has left.
  bool await_start() noexcept;
  /// Sleeps until the slot's gate differs from `seen` or the deadline comes, and checks the host during this time.
  /// False: interrupted, failed, ended, or the host is lost; the process has left.
  bool sleep(std::uint32_t seen, std::int64_t deadline_ns) noexcept;
  void leave() noexcept;
  /// Checks the host at every wait under the real clock, 20 ms after the last check, because `sleep` does not check it
  /// while messages arrive. If the host is lost it interrupts this process; if the host is stopped it begins the
  /// shutdown (`stop`).
  void check_host() noexcept;

 private:
  MappedClock memory_;
  std::uint32_t index_;
  HostWatch host_;
  std::int64_t next_check_ns_ = 0;  // for the host; the participant's thread
};

}  // namespace mrroc::clock
