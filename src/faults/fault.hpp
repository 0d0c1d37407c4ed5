#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "mrroc/types.hpp"

namespace mrroc::faults {

/// What an injected fault does, by the word that asks for it.
enum class Kind : std::uint8_t {
  // of a process; the runner does it
  kill,  ///< SIGKILL
  halt,  ///< SIGSTOP: it is there and does nothing
  end,   ///< SIGTERM: it leaves early
  // of a robot's drives; its EDP's hardware seems to do it, or one simulated drive on a bus does
  fault,        ///< a drive reports a fault
  silence,      ///< the drives, one drive, or a sensor's hardware, do not answer
  unreference,  ///< the drives have lost their positions
  jump,         ///< an axis's encoder, or every value of a sensor, is off by `value`
  freeze,       ///< an axis's encoder, all that a drive says, or a sensor, continues giving the last value
  nan,          ///< an axis's encoder, or a sensor, gives something that is no number
  overload,     ///< an axis's measured current is `value` times its greatest one
  disconnect,   ///< an axis's motor gets no current
  runaway,      ///< an axis's motor gets its greatest current, whatever the regulator says
  // of one simulated drive on a bus
  restart,  ///< it boots
  hush,     ///< its heartbeats do not come
  press,    ///< the positive limit switch of its axis is on
  // of the commands that a task program sends to its robots
  lose,     ///< they do not arrive
  delay,    ///< each is sent `value` ticks later
  corrupt,  ///< their numbers are no numbers; of each frame of a simulated drive one byte is another
  leap      ///< their target is `value` rad or m farther, in every joint
};

/// Whether it strikes any process, by a signal of the runner; the others are made by the process that they strike.
bool is_signal(Kind kind) noexcept;

/// One fault to be injected into a run: what, whom, when, for how long.
struct InjectedFault {
  Kind kind = Kind::kill;
  std::string process;   ///< as the deployment names it: mp, arm, arm_edp, arm_drives, wrist, sim
  std::size_t axis = 0;  ///< from 0; of the kinds that strike one axis
  double value = 0;      ///< see Kind
  bool at_step = false;  ///< `when` counts the steps of process `counter`; else it is a tick
  std::uint64_t when = 0;
  std::string counter;     ///< the task process whose steps are counted, from its start; empty: not by steps
  Tick duration = kNever;  ///< ticks; kNever: forever
  std::string text;        ///< as it was given
};

/// Reads one fault. Words, `[]` optional:
///
///     ACTION TARGET [axis N] [by X] at (tick N | step N [of PROCESS]) [for N ticks]
///
/// TARGET: `mp`, `sim`, `ecp:ROBOT`, `edp:ROBOT`, `drives:ROBOT` (simulated ones on a bus), `vsp:SENSOR`. Axes count
/// from 1. Steps are those of the target when it runs a task, of the robot's ECP for an EDP or drives, else PROCESS
/// must be named. Examples: "kill ecp:arm at step 120", "jump edp:arm axis 2 by 0.5 at tick 800", "lose ecp:arm at tick
/// 500 for 100 ticks".
///
/// Throws std::invalid_argument that names the word that is wrong and what was expected. Any thread.
InjectedFault parse_fault(const std::string& text);

}  // namespace mrroc::faults
