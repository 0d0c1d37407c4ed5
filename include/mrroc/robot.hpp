#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "mrroc/robot_link.hpp"
#include "mrroc/time_scale.hpp"
#include "mrroc/tool_kinematics.hpp"

namespace mrroc {

class Task;

/// One effector e_l in a task program: its state e^i, the command e^{i+1} that a generator writes, its geometry. It
/// exchanges state and command in the same manner at ECP and MP level (the paper: "each robot knows how to interact").
/// A robot of a given type is a class derived from this one (`Irb6`). Task's thread only.
class Robot {
 public:
  /// `name`: as in the deployment; empty in an ECP: its own robot. `models`: at least one. A member of the task, or
  /// made in its constructor. Throws NonFatalError(invalid_argument) when the deployment has no such robot of the
  /// model's type, or when the task is already running and has not opened the link before.
  Robot(Task& task, const std::string& name, RobotModels models);
  /// The same, with the models that `load` reads from the robot's parameter file: the one that the deployment names, or
  /// with an empty path that of `type`. Also throws the errors of `load`: ConfigurationError.
  Robot(Task& task, const std::string& name, const std::string& type,
        RobotModels (*load)(const std::filesystem::path& parameters));
  virtual ~Robot() = default;
  Robot(const Robot&) = delete;
  Robot& operator=(const Robot&) = delete;

  const std::string& name() const noexcept { return name_; }
  Task& task() const noexcept { return *task_; }
  const RobotModels& models() const noexcept { return models_; }
  const RobotParameters& parameters() const noexcept { return models_.front()->parameters(); }
  /// The model and the tool in use according to the robot's state; before the first state the first model with its own
  /// tool.
  ToolKinematics kinematics() const noexcept;

  /// e^i, as of the last step of a Move or Wait.
  const RobotState& state() const noexcept { return state_; }
  /// The same, for a generator that plans from it. Throws NonFatalError(invalid_argument) without a state: the robot
  /// has not been in the list of any Move or Wait.
  const RobotState& known_state() const;
  /// e^{i+1}. Before each `Generator::next_state()` it is reset to "hold" with this robot's macrostep.
  RobotCommand& command() noexcept { return command_; }
  const RobotCommand& command() const noexcept { return command_; }

  /// Macrostep of the coming instructions: N ticks, reply at tick v (default 10 / 8, the original's). Throws
  /// NonFatalError when N is not in 1..kMaxMotionSteps or v not in 1..N+1.
  void set_macrostep(std::uint16_t motion_steps, std::uint16_t reply_step);
  std::uint16_t motion_steps() const noexcept { return motion_steps_; }
  std::uint16_t reply_step() const noexcept { return reply_step_; }
  /// Seconds from one state to the next: N * servo period.
  double step_duration() const noexcept;

  // ---- changes of the robot itself: one exchange each, outside any Move. They throw the robot's error when it
  // refuses: NonFatalError (invalid_argument, busy while it moves, not_synchronised), HardwareError (a persistent
  // fault).
  /// Sets the tool frame, in the flange frame, to which poses and twists refer from now on.
  void set_tool(const Pose& tool);
  /// Selects the kinematic model by name. Throws NonFatalError(invalid_argument) that lists the valid names.
  void use_model(std::string_view name);
  /// Finds the absolute positions of the motors: switch, zero pulse, axis by axis. Returns when done.
  void synchronise();
  /// After a HardwareError: clears the fault and switches the drives on. The robot holds its measured position.
  void recover();
  /// Takes the present reading of the robot's force sensor as zero, for the force law and the force limits.
  void bias_force();
  /// The tool carries `load` from now on, besides its own weight; the centre in the tool frame in use, m. The robot's
  /// force law and force limits (`force_sensor` of the deployment) take its weight off in every posture, as those of
  /// `tool_mass`; mass 0: the tool is empty. A ForceTorque of the task is configured by itself (`Carrying`). Throws
  /// NonFatalError(invalid_argument) when the mass is negative or above 1000 kg, the centre farther than 10 m, or the
  /// robot has no force sensor.
  void carry(const Load& load);
  /// Selects the servo regulators by the name of their set in the robot's parameter file; "standard" is its own. Throws
  /// NonFatalError(invalid_argument) that lists the valid names.
  void use_regulators(std::string_view name);
  /// Sets the outputs of the robot's controller from the next servo tick on; also while it moves.
  void set_outputs(const ControllerIo& outputs);

  // ---- the exchange, used by Move and Wait
  // -----------------------------------------------------------------------------
  /// Resets the command to a plain `kind` with this robot's macrostep.
  void reset_command(CommandKind kind) noexcept;
  /// Reserves the robot for one instruction, until `release`. Throws NonFatalError(busy) when an instruction of another
  /// fiber of the task has it.
  void acquire();
  void release() noexcept { in_use_ = false; }
  void send() { link_->send(command_); }
  void receive() { link_->receive(state_); }
  /// The state of the last exchange, for Move, which shows a generator the desired values in the generator's own time.
  RobotState& exchanged_state() noexcept { return state_; }
  /// The operator's speed at the end of the macrostep commanded last.
  TimeScale& time_scale() noexcept { return time_scale_; }

 private:
  void change();
  void choose(CommandKind kind, const char* what, std::string_view name, const std::vector<std::string_view>& names);

  Task* task_;
  std::string name_;
  RobotModels models_;
  RobotLink* link_;
  RobotState state_;
  RobotCommand command_;
  TimeScale time_scale_;
  std::uint16_t motion_steps_ = 10;
  std::uint16_t reply_step_ = 8;
  bool in_use_ = false;
};

}  // namespace mrroc
