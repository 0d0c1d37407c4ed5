#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "clock/clock.hpp"
#include "clock/clock_memory.hpp"
#include "clock/delta_cycle.hpp"
#include "clock/tick_events.hpp"

namespace mrroc::clock {

struct HostOptions {
  Mode mode = Mode::lockstep;
  double period = 0.002;                  ///< s
  std::vector<std::string> participants;  ///< names of the processes; their order is the order of the table
  std::uint64_t delta_limit = 1000;       ///< deltas in one tick; at least 2
  /// Messages may come through the operator clock at any moment: having no participant to wake is then not an error.
  bool live_operator = false;
};

/// The deployment's clock, owned by the process that starts the deployment (`mrroc run`, a test). Life cycle:
/// construct, start the processes with `fd()`, `wait_ready`, `start`, and at the end `end`. In lockstep and paced mode
/// it opens the deltas in its own thread; in real mode that thread runs events only. Any thread of the owner may call
/// it.
class ClockHost {
 public:
  /// Throws SystemError when an option is wrong or there is no memory.
  explicit ClockHost(const HostOptions& options);
  /// Ends the clock and joins its thread.
  ~ClockHost();

  /// Descriptor of the clock's memory, for `attach_clock` in the children; it closes on exec unless it is passed to a
  /// child.
  int fd() const noexcept { return memory_.fd(); }

  /// Waits until every participant is ready, but not longer than `timeout` s of wall time and not when the clock has
  /// failed or ended. Returns the names of those that are not.
  std::vector<std::string> wait_ready(double timeout);
  /// Runs `callback` in the host's thread before tick `tick` is visible, while every participant is blocked (real mode:
  /// when the tick begins). Its messages through the operator clock are visible at that tick. An exception fails the
  /// clock. For a tick that has passed: before the next one; the callback receives the tick that it really precedes.
  void at_tick(Tick tick, TickEvents::Callback callback);
  /// Opens tick 0 and continues in its own thread. `epoch_ns`: in real mode, the CLOCK_MONOTONIC time of tick 0 that
  /// all hosts of the deployment have agreed upon; 0: a few periods from now. Throws SystemError when a participant is
  /// not ready, or a topic has two senders, or the clock has failed or ended, or that time is past.
  void start(std::int64_t epoch_ns = 0);
  /// As `start`, but continues in the calling thread until the clock fails or ends.
  void run();

  /// The tick from which injected fault `index` is active; kNever: not yet. And to trigger it.
  Tick fault_tick(std::size_t index) const noexcept { return memory_->fault_ticks[index].load(); }
  void set_off_fault(std::size_t index, Tick tick) noexcept { clock::set_off_fault(*memory_, index, tick); }

  /// From now on no process waits for this participant, nor for messages from it or to it. Call when its owner has seen
  /// it die; no effect for a participant that has left on its own. Throws SystemError for an unknown name.
  void participant_died(std::string_view name);
  /// Whether it has left or died. An unknown name: true.
  bool has_left(std::string_view name) const noexcept;
  /// Begins the shutdown: the waits of tasks return `interrupted`, and no process waits for them any more. Time
  /// continues for drives and world (`Part`), which leave when the robots rest and their drives are off. Then call
  /// `end`. Before the start it is `end`.
  void stop();
  /// The newest tick when `stop` was called; kNever: it has not been.
  Tick stop_tick() const noexcept { return memory_->stop_tick.load(); }
  /// Real: a participant has found this process stopped by a signal, and has begun the shutdown itself.
  bool was_stopped() const noexcept { return memory_->host_was_stopped.load() != 0; }
  /// The tick in which the task ended (Clock::end_task), a participant died, or `stop` was called, whichever came
  /// first; kNever: it runs. In simulated time the same in every run, but for a death or a stop at a moment of wall
  /// time.
  Tick task_end() const noexcept { return memory_->task_end.load(); }
  /// Every wait in every process returns `interrupted` from now on. The first call of the two takes effect.
  void fail(std::string_view text);
  void end();
  /// After `end`: waits for the host's thread, so that no event runs any more. Not from an event. The owner's thread.
  void join();

  /// The clock has failed, and this participant took part until then: its end is only a consequence.
  bool failed_with(std::string_view name) const noexcept;

  State state() const noexcept { return memory_->state.load(); }
  /// The reason of its failure; empty when it has not failed.
  std::string error() const;
  /// One line to print when time stands still: tick, delta, the busy participants and the messages in flight.
  std::string describe() const { return clock::describe(*memory_); }
  /// Simulated time: a participant is busy or a message is in flight, and time stands until then. Real: false.
  bool waits_for_somebody() const noexcept;
  /// Real: the participants between two waits, each with the number of waits that it has begun and ended; a participant
  /// whose number does not change computes or is blocked. Simulated time: empty.
  std::vector<std::pair<std::string, std::uint64_t>> at_work() const;
  /// The newest tick that participants may see.
  Tick tick() const noexcept;
  /// Of the servo, ns.
  std::int64_t period_ns() const noexcept { return memory_->period_ns; }
  /// Number of the open delta; it grows as long as anything happens. Lockstep and paced.
  std::uint64_t delta() const noexcept { return memory_->delta.load(); }
  /// Paced: ticks that were due before the previous tick was finished.
  std::uint64_t late_ticks() const noexcept { return cycle_.late_ticks(); }

  /// A clock for the owner's own links: it sends counted messages but no process waits for it. One per host
  /// (SystemError).
  std::unique_ptr<Clock> operator_clock();

 private:
  std::vector<std::string> not_ready() const;
  void open_time(std::int64_t epoch_ns);
  void loop();
  void run_events_in_real_time();

  MappedClock memory_;
  TickEvents events_;
  DeltaCycle cycle_;
  std::thread thread_;
};

}  // namespace mrroc::clock
