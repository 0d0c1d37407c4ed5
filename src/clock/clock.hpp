#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "clock/emergency_stop.hpp"
#include "mrroc/types.hpp"

namespace mrroc::clock {

/// What a process is to the deployment when it comes to its end.
enum class Part : std::uint32_t {
  task,    ///< it tells others what to do or measure: it leaves at once
  drives,  ///< it moves a robot: it continues until the robot stands and its drives are off
  world    ///< the simulated world: it continues until no robot is driven any more; in a new tick it runs first, alone
};

/// Why a wait ended.
enum class Wake {
  mail,        ///< something new has become visible in the process's mailbox
  tick,        ///< the tick waited for has come
  interrupted  ///< the process is asked to end, or the deployment has failed
};

/// One process's view of the deployment's time, and its mailbox's gate. Three implementations: real, and lockstep
/// (which `paced` shares: only the host differs). The task's (participant's) thread calls everything but what is marked
/// otherwise.
///
/// Life: construct, register links, `start()` (the start-up barrier), then `wait()` again and again.
class Clock {
 public:
  virtual ~Clock() = default;

  /// Servo period, s.
  virtual double period() const noexcept = 0;
  /// Now. In lockstep it is constant while the participant runs. Any thread.
  virtual Tick tick() const noexcept = 0;
  /// True under lockstep and paced: time is the host's, nothing may read the wall clock.
  virtual bool simulated() const noexcept = 0;
  /// CLOCK_MONOTONIC time at which tick 0 begins, ns: the grid of a servo thread's `Ticker`. Real and paced, after
  /// `start()`; otherwise 0. Any thread.
  virtual std::int64_t epoch_ns() const noexcept { return 0; }
  /// Monotonic wall time in seconds, for reports only (durations, counters); never for decisions. Any thread.
  virtual double wall_seconds() const noexcept = 0;

  /// Says "ready" and blocks until the host has seen every participant ready and opened tick 0. False: interrupted.
  virtual bool start() = 0;
  /// Blocks until mail arrives that was not visible at the end of the last wait, or `wake_tick` comes (kNever: mail
  /// only). When both have come it returns `tick`: look into the mailbox after every wait. In lockstep a wake tick that
  /// has already passed ends the wait in the next delta. After `interrupted` no one waits for this process any more.
  virtual Wake wait(Tick wake_tick) = 0;

  /// The deployment is coming to its end: drives are to be switched off by a stop, and the process is to leave then.
  /// The waits of tasks return `interrupted` already, those of drives and world do not before all is over. Any thread.
  virtual bool stopping() const noexcept { return false; }
  /// Makes the present and every later wait return `interrupted`. Any thread, signal handlers too.
  virtual void interrupt() noexcept = 0;
  /// Wakes the participant's thread as if mail had arrived. Real clock only: another thread of the process has
  /// something for it. Any thread; a futex wake, no lock.
  virtual void notify() noexcept = 0;
  /// The operator's emergency stop of this deployment; it lives as long as the clock. Any thread.
  virtual EmergencyStop& emergency_stop() noexcept = 0;

  // ---- for injected faults (src/faults)
  /// The tick from which injected fault number `index` is in force; kNever: not yet. Any thread.
  virtual Tick fault_tick(std::size_t /*index*/) const noexcept { return kNever; }
  /// Sets it off, unless that has been done. Any thread.
  virtual void set_off_fault(std::size_t /*index*/, Tick /*tick*/) noexcept {}

  // ---- for the links ------------------------------------------------------------------------------------------------
  /// Declares that this process sends (receives) on `topic`; returns the handle for `sent` (`arrived`). Before
  /// `start()`.
  virtual int register_sender(std::string_view topic) = 0;
  virtual int register_receiver(std::string_view topic) = 0;
  /// To be put into a message about to be sent.
  virtual std::uint64_t delta() const noexcept = 0;
  /// Whether a message that carries this delta may be seen yet: in lockstep, only in a later delta than its own. Any
  /// thread.
  virtual bool visible(std::uint64_t delta) const noexcept = 0;
  /// Counts a message in flight to every registered receiver of the topic; call *before* writing it.
  virtual void sent(int sender) noexcept = 0;
  /// Takes one message off and wakes the participant when due. The listener's thread; call after the sample is stored.
  virtual void arrived(int receiver) noexcept = 0;
};

}  // namespace mrroc::clock
