#pragma once

#include <utility>

#include "clock/participant_clock.hpp"

namespace mrroc::clock {

/// The runner's own view of lockstep time. Its messages are counted and stamped with the open delta. Sent from a
/// callback of `ClockHost::at_tick` they arrive at the same tick and delta on every run; sent at any other moment they
/// arrive safely but at an arbitrary tick. No process waits for the operator: the messages it receives are not counted
/// and are visible at once. Any thread may send; one thread waits.
class OperatorClock final : public ParticipantClock {
 public:
  explicit OperatorClock(MappedClock memory) : ParticipantClock(std::move(memory), kOperator) {}

  Tick tick() const noexcept override { return memory().tick.load(); }
  bool simulated() const noexcept override { return true; }
  /// Blocks until the host has started.
  bool start() override { return await_start(); }
  /// Checks the time every 10 ms of wall time: ticks do not wake the operator.
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
