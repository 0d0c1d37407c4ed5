#pragma once

#include <vector>

#include "cli/trace/rule.hpp"

namespace mrroc::cli::trace {

/// e^{i+1} of one robot with the command and the state that precede it.
struct Answer {
  const RobotEntry& from;       ///< e^i
  const CommandEntry& command;  ///< the command
  const RobotEntry& to;         ///< e^{i+1}
  /// When the macrostep before ends: the state's `desired_tick`; after a force motion the end of its macrostep, which
  /// is not in the state.
  Tick end_before = 0;
  /// A motion after a force motion: it begins after a stop whose end is not in the trace, and may take longer.
  bool after_force = false;
  /// The command came after the robot had begun to brake: it may take longer, too.
  bool late = false;
  /// A robot of several in one Move.
  bool in_group = false;
  /// It rests, and another robot of the Move has stopped alone: it may have stopped with that one, anywhere.
  bool joined = false;
  /// The robot executed a command of its ECP, equation (11): a step of that process has it.
  bool by_ecp = false;

  /// The robot stopped first, because the command begins later than the motion before ended.
  bool stopped_first() const noexcept { return from.moving && to.macrostep != end_before; }
  /// The desired state at the macrostep's start is that of `from`.
  bool continues() const noexcept { return !after_force && !late && !stopped_first(); }
  /// The robot has held instead: it had braked in step with the others of its Move, or the operator had moved it
  /// meanwhile. A late command to a single robot that had rested has no other reason.
  bool held_instead() const noexcept { return late && !to.moving && (in_group || !from.moving); }
  /// The state is from after the macrostep, and describes a stop instead of the macrostep's end.
  bool braked() const noexcept { return to.tick > to.macrostep + command.motion_steps && to.desired_tick > to.tick; }
};

/// The ECP has left the Move of its MP between these states of a robot: it may have left the command unexecuted.
bool has_left(const RobotEntry& from, const RobotEntry& to);

/// Whether a robot beside number `self` has stopped alone: it reports an error or a late command, or its ECP has left.
/// The line before has as many robots.
bool has_another_stopped(const Step& step, std::size_t self);

/// One for each robot whose state in the step answers the command of the step before without an error. Empty where the
/// robots held or were queried in between, or the exchange was broken off.
std::vector<Answer> answers(const Step& step);

}  // namespace mrroc::cli::trace
