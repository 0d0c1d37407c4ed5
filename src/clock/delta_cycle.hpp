#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <string>

#include "clock/clock_memory.hpp"
#include "clock/tick_events.hpp"

namespace mrroc::clock {

/// The lockstep host's loop. Whenever no participant runs and no message is in flight it opens the next delta:
///   1. for every participant that has mail or whose wake tick has come;
///   2. otherwise for the next tick: the events of that tick, then its physics participants alone; after that the tick
///      is visible and 1. finds the participants that wait for it.
/// Paced: step 2 does not begin tick k before epoch + k T; until then mail is delivered.
///
/// It fails the clock when the deltas of one tick exceed the limit (a zero-time loop), when no participant waits for a
/// tick and no message is in flight (a dead end), and when a link counts more arrivals than messages.
class DeltaCycle {
 public:
  /// `live_operator`: messages may come from outside at any moment, so that having no participant to wake is not a dead
  /// end.
  DeltaCycle(ClockMemory& memory, TickEvents& events, std::uint64_t delta_limit, bool live_operator) noexcept
      : memory_(memory), events_(events), delta_limit_(delta_limit), live_operator_(live_operator) {}

  /// Runs until the clock's state is no longer `running`. The host's thread.
  void run();
  /// Paced: ticks that were due before the previous tick was finished. Any thread.
  std::uint64_t late_ticks() const noexcept { return late_ticks_.load(); }

 private:
  enum class Who { anybody, physics };

  bool await_quiescence();
  bool counts_agree();
  bool open_delta(Who caller);
  bool wait_for_next_tick();
  bool dead_end();
  void begin_next_tick();
  void fail_zero_time_loop();
  void fail_dead_end();

  ClockMemory& memory_;
  TickEvents& events_;
  std::uint64_t delta_limit_;
  bool live_operator_;

  std::uint32_t seen_ = 0;  // the host gate's word before the last check of the table
  Tick next_tick_ = 0;      // not yet visible
  std::uint64_t deltas_in_tick_ = 0;
  bool first_look_ = true;  // at the next tick's time
  std::array<std::uint64_t, kMaxParticipants> seen_mail_{};
  std::array<std::uint64_t, kMaxParticipants> last_delta_{};  // in which it ran
  std::atomic<std::uint64_t> late_ticks_{0};
};

/// One line for people: the tick, the delta, the running participants and the messages in flight. Any thread.
std::string describe(const ClockMemory& memory);

}  // namespace mrroc::clock
