#pragma once

#include "clock/participant_clock.hpp"

namespace mrroc::clock {

/// Wall time: tick() = floor((now - epoch) / T) of CLOCK_MONOTONIC, 0 before the epoch. The host announces one epoch,
/// a few periods ahead, to all processes at once; `start()` returns then, so that a servo thread can be started before
/// tick 0. Messages are visible at once and not counted.
class RealClock final : public ParticipantClock {
 public:
  using ParticipantClock::ParticipantClock;

  Tick tick() const noexcept override;
  bool simulated() const noexcept override { return false; }
  bool start() override;
  Wake wait(Tick wake_tick) override;
  void notify() noexcept override;

  int register_sender(std::string_view) override { return 0; }
  int register_receiver(std::string_view) override { return 0; }
  std::uint64_t delta() const noexcept override { return 0; }
  bool visible(std::uint64_t) const noexcept override { return true; }
  void sent(int) noexcept override {}
  void arrived(int) noexcept override { notify(); }

 private:
  Wake wait_for(Tick wake_tick);

  std::uint32_t seen_ = 0;  // openings of the gate that earlier waits have reported
};

}  // namespace mrroc::clock
