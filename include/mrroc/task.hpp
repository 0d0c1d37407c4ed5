#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "mrroc/black_box.hpp"
#include "mrroc/load.hpp"
#include "mrroc/measured_arm.hpp"
#include "mrroc/robot_link.hpp"
#include "mrroc/sensor_link.hpp"
#include "mrroc/types.hpp"

namespace mrroc {

class StepObserver;
class TrajectoryLink;

/// The request of the operator or the superior process for the current instruction.
enum class OperatorRequest : std::uint8_t {
  none = 0,
  pause = 1,      ///< hold until resumed
  stop = 2,       ///< leave the task: `Stopped` is thrown
  end_motion = 3  ///< end this Move or Wait as if its condition had held
};

/// The process of a task program, used by `Robot`, `Sensor`, `Move` and `Wait` for links, the time and the operator.
/// `ecp::Task` and `mp::Task` implement it over DDS, tests over fakes. All methods: task's thread.
class Task {
 public:
  virtual ~Task() = default;
  Task() = default;
  Task(const Task&) = delete;
  Task& operator=(const Task&) = delete;

  /// Name of the process, for errors and traces.
  virtual const std::string& process_name() const noexcept = 0;
  /// Name of the robot meant by `requested`: in an ECP, its own robot when empty. Throws NonFatalError when there is no
  /// such robot.
  virtual std::string robot_name(const std::string& requested) const = 0;
  /// The parameter file that the deployment names for robot `name` of type `type`. Empty: the file of the type. Also
  /// empty when the deployment has no such robot, which `robot_link` reports. With `type` empty: the file of the robot
  /// of any type, also when the deployment names none.
  virtual std::filesystem::path robot_parameters(const std::string& /*name*/, const std::string& /*type*/) const {
    return {};
  }
  /// The load on the flange of robot `name`, by the deployment; none: its mass is 0.
  virtual Load robot_load(const std::string& /*name*/) const { return {}; }
  /// How robot `name` differs from the model of its type, by the deployment; nothing: not measured.
  virtual MeasuredArm measured_arm(const std::string& /*name*/) const { return {}; }
  /// The link to robot `name` of type `type` (its EDP or ECP). Throws NonFatalError(invalid_argument) when the
  /// deployment has no such robot, has it as another type, or the task is already running and has no link to it: links
  /// are opened while the task object is built, and live as long as the task. Later calls return the same link.
  virtual RobotLink& robot_link(const std::string& name, const std::string& type) = 0;
  /// The link to sensor `name` of type `type`, in the same manner. `interactive`: how it is deployed.
  virtual SensorLink& sensor_link(const std::string& name, const std::string& type, bool& interactive) = 0;

  /// The link on which trajectories of other programs come; null: none come.
  virtual TrajectoryLink* trajectory_link() noexcept { return nullptr; }

  /// Length of a servo tick, s.
  virtual double servo_period() const noexcept = 0;
  /// The present tick.
  virtual Tick tick() const noexcept = 0;
  /// Monotonic wall time, s: for reports only.
  virtual double wall_seconds() const noexcept = 0;
  /// Waits until `tick`. Throws Stopped when the process is asked to end.
  virtual void sleep_until(Tick tick) = 0;

  /// The request for the instruction at this step; never waits. In an MP it throws the error of an ECP that the MP has
  /// started and that has failed since.
  virtual OperatorRequest operator_request() = 0;
  /// The speed that the operator wants, as a fraction of the programmed one: above 0, at most 1.
  virtual double operator_speed() const noexcept { return 1; }
  /// True once for each trigger that the operator gave.
  virtual bool take_trigger() = 0;
  /// Receives every step; may be null. It must neither allocate nor block.
  virtual StepObserver* observer() noexcept = 0;

  /// The last steps of this task's Moves and Waits, updated by every step. Task's thread.
  BlackBox& black_box() noexcept { return black_box_; }
  const BlackBox& black_box() const noexcept { return black_box_; }

  /// Number of an instruction, when its first step is observed; counts from 1. Used by Move and Wait.
  std::uint64_t begin_instruction() noexcept { return ++instructions_; }

 private:
  BlackBox black_box_;
  std::uint64_t instructions_ = 0;
};

}  // namespace mrroc
