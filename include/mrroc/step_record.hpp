#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mrroc/robot_command.hpp"
#include "mrroc/robot_state.hpp"
#include "mrroc/sensor_link.hpp"

namespace mrroc {

/// The reason why an instruction ends at a step.
enum class StepEnding : std::uint8_t {
  none,             ///< nothing: it continues, and every robot is commanded
  condition,        ///< the condition waited for, or given to the generator with `until`, holds: f_I, f_T
  generator,        ///< the generator's own terminal condition holds: f_T
  end_motion,       ///< the operator or the superior process asks for the next instruction
  stopped,          ///< `Stopped` is thrown
  non_fatal_error,  ///< f_E: an Error of this class is thrown
  hardware_error,
  system_error
};

/// The data common to all steps of one Move or Wait.
struct InstructionRecord {
  struct SensorEntry {
    std::string name;
    std::uint32_t period = 1;  ///< steps
    bool interactive = true;
    std::uint32_t configuration = 0;  ///< that this task was the last to set: readings are made with it or a later one
  };

  std::uint64_t number = 0;  ///< counts the task's instructions, from 1, in the order of their first steps
  bool is_move = false;
  std::string name;                  ///< of the generator, or of the condition waited for
  std::optional<std::string> until;  ///< of a Move: name of its condition, if any
  std::vector<std::string> robots;
  std::vector<SensorEntry> sensors;
  std::vector<std::string> conditions;  ///< leaves of the condition
};

/// One step of a Move or Wait, after f_T / f_I and the next command are known, or when an error ends it: copies of all
/// states, readings and commands. The lists are in the order of the instruction's.
struct StepRecord {
  std::shared_ptr<const InstructionRecord> instruction;
  /// i - i0. When `Stopped` or a SystemError aborts an exchange, it is that of the unanswered command.
  std::uint64_t step = 0;
  /// Macrosteps in which the robots held between the previous command and this step: a pause, a late command.
  std::uint64_t held = 0;
  /// The states come from a query since the previous command, because a generator planned again: in an ECP that of an
  /// MP that takes part.
  bool obtained = false;
  Tick tick = 0;  ///< of the newest state or reading
  StepEnding ending = StepEnding::none;
  Tick skew = 0;                         ///< of the robots, worst so far in this instruction: Outcome::skew
  std::vector<RobotState> states;        ///< e^i
  std::vector<RobotCommand> commands;    ///< e^{i+1}; empty where the instruction ends
  std::optional<RobotCommand> superior;  ///< c_0 in an ECP whose Move the MP takes part in: its command of this step
  std::vector<SensorReading> readings;   ///< v^i
  /// Whether each leaf holds. Empty at an end without evaluation: end-motion, `Stopped`, errors.
  std::vector<std::uint8_t> conditions;

  /// The instruction ends here: no command is sent.
  bool last() const noexcept { return ending != StepEnding::none; }
};

}  // namespace mrroc
