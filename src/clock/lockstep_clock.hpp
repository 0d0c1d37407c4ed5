#pragma once

#include <atomic>

#include "clock/participant_clock.hpp"

namespace mrroc::clock {

/// Simulated time by delta cycles, for lockstep and paced. The process runs only in the deltas that the host opens for
/// it; messages sent in one delta are visible only in later ones, so the messages that a process sees do not depend on
/// the speed of any process. `wait`, `sent` and `arrived` allocate nothing and take no lock.
class LockstepClock : public ParticipantClock {
 public:
  using ParticipantClock::ParticipantClock;

  Tick tick() const noexcept override { return tick_.load(); }
  bool simulated() const noexcept override { return true; }
  bool start() override;
  Wake wait(Tick wake_tick) override;
  /// Does nothing: in lockstep only messages and ticks wake a process.
  void notify() noexcept override {}

  int register_sender(std::string_view topic) override;
  int register_receiver(std::string_view topic) override;
  std::uint64_t delta() const noexcept override { return delta_.load(); }
  bool visible(std::uint64_t delta) const noexcept override { return delta < delta_.load(); }
  void sent(int sender) noexcept override;
  void arrived(int receiver) noexcept override;

 private:
  void update_time() noexcept;
  /// What the process still does belongs to the tick of the interruption, not to the one in which it fell asleep.
  Wake interrupted() noexcept;

  std::atomic<Tick> tick_{0};
  std::atomic<std::uint64_t> delta_{0};
};

}  // namespace mrroc::clock
