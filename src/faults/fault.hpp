#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "mrroc/types.hpp"

namespace mrroc::faults {

/// The effect of an injected fault; each name is the word in the text of a fault.
enum class Kind : std::uint8_t {
  // of a process; caused by the runner
  kill,  ///< SIGKILL
  halt,  ///< SIGSTOP: it exists but does not run
  end,   ///< SIGTERM: it leaves early
  // of a robot's drives; simulated in the hardware of its EDP, or in one simulated drive or I/O node on a bus
  fault,        ///< a drive or an I/O node reports a fault
  silence,      ///< the drives, one drive, one I/O node, or a sensor's hardware, do not answer
  unreference,  ///< the drives have lost their positions
  jump,         ///< an axis's encoder, or every value of a sensor, is off by `value`
  freeze,       ///< an axis's encoder, all values of a drive, or a sensor, repeat the last value
  nan,          ///< an axis's encoder, or a sensor, returns NaN
  overload,     ///< an axis's measured current is `value` times its maximum
  disconnect,   ///< an axis's motor gets no current
  runaway,      ///< an axis's motor gets its maximum current, ignoring the regulator
  // of one simulated drive, or of one simulated I/O node, on a bus
  restart,  ///< it boots
  hush,     ///< its heartbeats are missing
  press,    ///< the positive limit switch of its axis is on
  // of an input of a simulated I/O node on a bus
  stick,  ///< it has the value `value`, at any state of its wire
  // of the commands that a task program sends to its robots
  lose,     ///< they do not arrive
  delay,    ///< each is sent `value` ticks later
  corrupt,  ///< their numbers become NaN; one byte of each frame of a simulated drive is changed
  leap      ///< their target is `value` rad or m farther, in every joint
};

/// Whether the runner causes it by a signal, in any process; the affected process causes the others itself.
bool is_signal(Kind kind) noexcept;

/// The part of a robot's simulated I/O nodes that a fault affects.
enum class IoPart : std::uint8_t { none, node, digital_input, analog_input };

/// One fault to be injected into a run: kind, target, time, duration.
struct InjectedFault {
  Kind kind = Kind::kill;
  std::string process;   ///< its name in the deployment: mp, arm, arm_edp, arm_drives, wrist, sim
  std::size_t axis = 0;  ///< from 0; of the kinds that affect one axis
  IoPart io = IoPart::none;
  int io_number = 0;     ///< of the node on its bus, 1 to 127; of the robot's input, from 0
  double value = 0;      ///< see Kind
  bool at_step = false;  ///< `when` counts the steps of process `counter`; else it is a tick
  std::uint64_t when = 0;
  std::string counter;     ///< the task process whose steps are counted, from its start; empty: not by steps
  Tick duration = kNever;  ///< ticks; kNever: without end
  std::string text;        ///< as it was given
};

/// Reads one fault. Words, `[]` optional:
///
///     ACTION TARGET [axis N | node N | (input | analog) N to X] [by X] at (tick N | step N [of PROCESS]) [for N ticks]
///
/// TARGET: `mp`, `sim`, `ecp:ROBOT`, `edp:ROBOT`, `drives:ROBOT` and `io:ROBOT` (simulated drives and I/O nodes on a
/// bus), `vsp:SENSOR`. Axes count from 1, inputs from 0. Steps are those of the target when it runs a task, of the
/// robot's ECP for an EDP or drives, else PROCESS must be named. Examples: "kill ecp:arm at step 120", "jump edp:arm
/// axis 2 by 0.5 at tick 800", "lose ecp:arm at tick 500 for 100 ticks".
///
/// Throws std::invalid_argument that names the wrong word and what was expected. Any thread.
InjectedFault parse_fault(const std::string& text);

}  // namespace mrroc::faults
