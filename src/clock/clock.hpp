#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "clock/emergency_stop.hpp"
#include "clock/group_stops.hpp"
#include "mrroc/types.hpp"

namespace mrroc::clock {

/// The role of a process in the shutdown of the deployment.
enum class Part : std::uint32_t {
  task,    ///< it commands others or measures: it leaves at once
  drives,  ///< it moves a robot: it continues until the robot rests and its drives are off
  world    ///< the simulated world: it continues until no robot is driven; in a new tick it runs first, alone
};

/// Why a wait ended.
enum class Wake {
  mail,        ///< something new has become visible in the process's mailbox
  tick,        ///< the tick waited for has come
  interrupted  ///< the process should end, or the deployment has failed
};

/// One process's view of the deployment's time, and its mailbox's gate. Three implementations: real, and lockstep
/// (which `paced` shares: only the host differs). The task's (participant's) thread calls every function unless marked
/// otherwise.
///
/// Life cycle: construct, register links, `start()` (the start-up barrier), then `wait()` repeatedly.
class Clock {
 public:
  virtual ~Clock() = default;

  /// Servo period, s.
  virtual double period() const noexcept = 0;
  /// Now. In lockstep it is constant while the participant runs. Any thread.
  virtual Tick tick() const noexcept = 0;
  /// True under lockstep and paced: time is the host's, and the wall clock must not be read.
  virtual bool simulated() const noexcept = 0;
  /// CLOCK_MONOTONIC time at which tick 0 begins, ns: the grid of a servo thread's `Ticker`. Real and paced, after
  /// `start()`; otherwise 0. Any thread.
  virtual std::int64_t epoch_ns() const noexcept { return 0; }
  /// Monotonic wall time in seconds, for reports only (durations, counters); never for decisions. Any thread.
  virtual double wall_seconds() const noexcept = 0;

  /// Reports ready and blocks until every participant is ready and the host has opened tick 0. False: interrupted.
  virtual bool start() = 0;
  /// Blocks until mail arrives that was not visible at the end of the last wait, or `wake_tick` comes (kNever: mail
  /// only). When both have come it returns `tick`: check the mailbox after every wait. In lockstep a wake tick that has
  /// already passed ends the wait in the next delta. After `interrupted` no process waits for this one.
  virtual Wake wait(Tick wake_tick) = 0;

  /// The deployment is shutting down: switch off the drives by a stop, then leave. The waits of tasks already return
  /// `interrupted`, those of drives and world only at the end of the shutdown. Any thread.
  virtual bool stopping() const noexcept { return false; }
  /// Makes the present and every later wait return `interrupted`. Any thread, signal handlers too.
  virtual void interrupt() noexcept = 0;
  /// Wakes the participant's thread as if mail had arrived. Real clock only: for messages from another thread of the
  /// process. Any thread; a futex wake, no lock.
  virtual void notify() noexcept = 0;
  /// The operator's emergency stop of this deployment; same lifetime as the clock. Any thread.
  virtual EmergencyStop& emergency_stop() noexcept = 0;
  /// The stops of its robots that others join; same lifetime as the clock. Any thread.
  virtual GroupStops& group_stops() noexcept = 0;

  // ---- for injected faults (src/faults)
  /// The tick from which injected fault number `index` is active; kNever: not yet. Any thread.
  virtual Tick fault_tick(std::size_t /*index*/) const noexcept { return kNever; }
  /// Triggers it, unless it has been triggered. Any thread.
  virtual void set_off_fault(std::size_t /*index*/, Tick /*tick*/) noexcept {}

  /// The deployment's task has ended: from this tick on its processes only leave, which takes as long as it takes. The
  /// first call of all processes counts. The participant's thread.
  virtual void end_task() noexcept {}

  // ---- for the links ------------------------------------------------------------------------------------------------
  /// Declares that this process sends (receives) on `topic`; returns the handle for `sent` (`arrived`). Before
  /// `start()`.
  virtual int register_sender(std::string_view topic) = 0;
  virtual int register_receiver(std::string_view topic) = 0;
  /// The delta for a message to be sent.
  virtual std::uint64_t delta() const noexcept = 0;
  /// Whether a message with this delta is visible yet: in lockstep, only in a later delta than its own. Any thread.
  virtual bool visible(std::uint64_t delta) const noexcept = 0;
  /// Counts a message in flight to every registered receiver of the topic; call *before* writing it.
  virtual void sent(int sender) noexcept = 0;
  /// Counts one message as arrived and wakes the participant when due. The listener's thread; call after the sample is
  /// stored.
  virtual void arrived(int receiver) noexcept = 0;
};

}  // namespace mrroc::clock
