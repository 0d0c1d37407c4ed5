#pragma once

#include <utility>

#include "clock/participant_clock.hpp"

namespace mrroc::clock {

/// The runner's own view of lockstep time. What it sends is counted and stamped with the delta that is open, so from a
/// callback of `ClockHost::at_tick` it arrives at the same tick and delta on every run; sent at any other moment it
/// arrives safely but at a tick that chance decides. No one waits for the operator: what it receives is not counted and
/// visible at once. Any thread may send; one thread waits.
class OperatorClock final : public ParticipantClock {
 public:
  explicit OperatorClock(MappedClock memory) : ParticipantClock(std::move(memory), kOperator) {}

  Tick tick() const noexcept override { return memory().tick.load(); }
  bool simulated() const noexcept override { return true; }
  /// Blocks until the host has started.
  bool start() override { return await_start(); }
  /// Looks at the time every 10 ms of wall time: no one wakes the operator for a tick.
  Wake wait(Tick wake_tick) override;
  void notify() noexcept override { slot().gate.open(); }

  int register_sender(std::string_view topic) override { return add_sender(memory(), index(), topic); }
  int register_receiver(std::string_view) override { return 0; }
  std::uint64_t delta() const noexcept override { return memory().delta.load(); }
  bool visible(std::uint64_t) const noexcept override { return true; }
  void sent(int sender) noexcept override { count_sent(memory(), sender); }
  void arrived(int) noexcept override { notify(); }

 private:
  std::uint32_t seen_ = 0;
};

}  // namespace mrroc::clock
