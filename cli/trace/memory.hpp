#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>

#include "cli/trace/reader.hpp"

namespace mrroc::cli::trace {

/// The record of an instruction that continues.
struct InstructionMemory {
  Line before;                         ///< its last step
  bool interrupted = false;            ///< steps after `before` are missing
  Tick skew = 0;                       ///< worst spread of the robots' macrosteps so far
  bool skew_is_known = true;           ///< the skew of every step was seen
  std::set<std::string> goes_on_with;  ///< values of the condition's parts at which it continued, as "0110"
};

/// The record of a process.
struct ProcessMemory {
  std::uint64_t lines = 0;
  std::size_t last_line = 0;           ///< number in the file
  std::uint64_t last_instruction = 0;  ///< greatest that has begun
  std::map<std::uint64_t, InstructionMemory> open;
  std::map<std::string, RobotEntry> robots;    ///< last state, without the command
  std::map<std::string, SensorEntry> sensors;  ///< last reading
  bool ended = false;                          ///< its end was read
};

/// The last command of a process to a robot.
struct Commanded {
  std::size_t line = 0;
  Tick tick = 0;
};

/// The record of a robot, for all processes that command it.
struct RobotMemory {
  bool answered = false;    ///< the command of the last state is known
  bool forced = false;      ///< the last command that it answered was a force motion: its end is not in the state
  std::uint64_t steps = 0;  ///< N of that command
  std::map<std::string, Commanded> by;  ///< by process
  /// Equation (11): the MP's last command that no step of the ECP shows yet, and the other way round.
  struct Side {
    Tick tick = 0;  ///< of the state of which it is the answer
    CommandEntry command;
  };
  std::optional<Side> wished, followed;
  /// The command of the other side about the step of `line`, where its step came first; else null.
  const CommandEntry* wish_of(const Line& line, const RobotEntry& robot) const;
};

/// The record of all steps so far: bounded by processes, robots and sensors, not by the trace's length.
struct Memory {
  bool simulated = true;
  bool black_box = false;  ///< the trace begins in the middle of its process's run
  std::uint64_t lines = 0;
  std::uint64_t instructions = 0;
  std::string last_process;  ///< of the step before
  Tick last_made = 0;        ///< its `made`
  std::map<std::string, ProcessMemory> processes;
  std::map<std::string, RobotMemory> robots;

  /// Null when there is no such process.
  const ProcessMemory* process(const std::string& name) const;
  const RobotMemory* robot(const std::string& name) const;
  /// The step before `line`, when it was in the trace; else null.
  const Line* before(const Line& line) const;
  /// The instruction of `line`, when it has begun and continues; else null.
  const InstructionMemory* instruction(const Line& line) const;

  /// `line` is the first one of an instruction that began before the black box.
  bool began_before(const Line& line) const;

  void take(const Line& line);
  void take(const ProcessEnd& end);
};

/// The values of all parts, one character each.
std::string key_of(const std::vector<ConditionEntry>& conditions);

/// Ticks between the first and the last start of the robots' macrosteps.
Tick spread(const Line& line);

}  // namespace mrroc::cli::trace
