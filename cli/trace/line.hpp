#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "mrroc/robot_command.hpp"
#include "mrroc/step_observer.hpp"

namespace mrroc::cli::trace {

using Numbers = std::vector<double>;

/// A command of a robot: e^{i+1}.
struct CommandEntry {
  CommandKind kind = CommandKind::hold;  ///< `set_tool` represents every change of the robot itself
  bool relative = false;
  Interpolation interpolation = Interpolation::joints;
  std::uint64_t motion_steps = 0;  ///< N
  std::uint64_t reply_step = 0;    ///< v
  Tick start_tick = 0;             ///< 0: none is given
  Numbers target;  ///< joints, shafts, pose, velocity or twist, according to the kind; for force: a twist, a wrench
  std::string behaviour;  ///< for force: a letter per axis

  bool operator==(const CommandEntry&) const = default;
};

/// A robot's state e^i, and what it is commanded. Units and frames are those of RobotState.
struct RobotEntry {
  std::string name;
  Tick tick = 0;
  Tick macrostep = 0;  ///< tick 0 of the macrostep that the state answers
  Numbers joints, pose;
  Tick desired_tick = 0;
  Numbers desired, desired_pose;  ///< poses: x, y, z, then the quaternion w, x, y, z
  bool moving = false;            ///< at `desired_tick`
  Coordination coordination = Coordination::none;
  std::uint64_t late = 0;  ///< late commands since the start
  Numbers wrench;          ///< empty where it is zero
  double lost = 0;         ///< lost fraction of a force motion's twist, 0..1
  ErrorClass error = ErrorClass::none;
  std::string error_code;  ///< in words
  std::optional<CommandEntry> command;
  std::optional<CommandEntry> superior;  ///< c_0: what the MP commands, in an ECP that takes part in its Move
};

enum class SensorMode { interactive, polled, published };

/// A reading of a sensor: v^i.
struct SensorEntry {
  std::string name;
  Tick tick = 0;
  Numbers values;
  std::uint64_t period = 1;  ///< steps
  SensorMode mode = SensorMode::interactive;
  std::uint64_t configuration = 0;  ///< with which the reading was made
  std::uint64_t configured = 0;     ///< that the process was the last to set

  /// The process has configured the sensor after `before`, and no reading has come since.
  bool emptied_since(const SensorEntry& before) const { return values.empty() && configuration > before.configuration; }
  ErrorClass error = ErrorClass::none;
  std::string error_code;  ///< in words
};

struct ConditionEntry {
  std::string name;
  bool value = false;
};

/// A step of a Move or Wait in a recording. src/messages/msg/mrroc_msgs/msg/Step.msg describes the fields.
struct Line {
  std::size_t number = 0;  ///< of its message in the file, from 1
  bool cut = false;        ///< it was too long: robots, sensors, conditions and ending are missing
  Tick made = 0;           ///< at which the process made it: the time of its message
  Tick tick = 0;           ///< the newest of its states and readings
  std::string process;
  std::uint64_t instruction = 0;
  bool is_move = false;
  std::string name;
  std::optional<std::string> until;
  std::uint64_t step = 0;
  std::uint64_t held = 0;
  bool obtained = false;  ///< the states are those of a query since the step before
  std::vector<RobotEntry> robots;
  std::vector<SensorEntry> sensors;
  std::vector<ConditionEntry> conditions;
  StepEnding ending = StepEnding::none;
  std::optional<Tick> skew;

  bool ends() const noexcept { return ending != StepEnding::none; }
  /// The instruction may have been interrupted in an exchange: the states need not be of one step.
  bool broken_off() const noexcept { return ending == StepEnding::stopped || ending == StepEnding::system_error; }
};

}  // namespace mrroc::cli::trace
