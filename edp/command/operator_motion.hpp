#pragma once

#include <optional>

#include "edp/check/model_set.hpp"
#include "edp/command/effector.hpp"
#include "edp/command/operator_travel.hpp"
#include "mrroc/robot_command.hpp"

namespace mrroc::edp {

/// Motions and changes that the operator commands directly, while no task commands the robot.
///
/// Jog: `joint_velocity`, `twist`, or `motor` with the shafts' velocities and without positions. The robot changes to
/// the velocity within its limits. A jog is valid for kJogValidity; when no other one comes within that time, the robot
/// brakes within its limits (dead-man). Near a limit the jog becomes slower, then it ends.
///
/// Travel: `joint`, `motor` or `pose`, from rest to rest (OperatorTravel). The reply comes at its end; `hold` ends it
/// at any time. While the robot comes to rest after another motion of the operator, a travel waits for that.
///
/// `set_outputs` changes the one output `choice`: a digital one, or behind those an analogue one. All other kinds are
/// passed to the effector, one at a time.
///
/// A task has priority: its query, with which every Move and Wait begins, ends the operator's motion and is answered
/// when the robot rests. A motion that comes nevertheless, from a task that was paused, counts as late: the robot comes
/// to rest and holds instead, and the task plans again.
///
/// A paused task holds its robots with `hold` commands. An order with `choice` kTaskPaused (jog and travel) is
/// executed nevertheless; while the robot moves by it, the task's `hold` commands are answered here, at their tick v.
///
/// The macrosteps are commands of the effector with numbers of their own (`is_own`). One thread, the effector's; it
/// allocates in the constructor only, never throws, never waits.
class OperatorMotion {
 public:
  static constexpr double kJogValidity = 0.2;  ///< s
  static constexpr double kTaskIdle = 0.1;     ///< s after a task's last macrostep in which the robot is the task's
  static constexpr std::uint16_t kSteps = OperatorTravel::kSteps;  ///< ticks of a macrostep
  static constexpr std::uint8_t kTaskPaused = 1;

  /// All outlive it. `period` in s.
  OperatorMotion(Effector& effector, const ModelSet& models, double period);

  /// Whether a number is of a command of this object.
  static bool is_own(std::uint64_t number) noexcept { return (number & kOwn) != 0; }

  /// Begins a motion that had to wait for the end of a macrostep of the task, or for rest. Call it after every wake-up.
  /// True: it is refused, and `reply` is the answer to its order.
  bool update(Tick now, Reply& reply) noexcept;
  /// A task's command number `number` has been received at tick `now`. True: the operator moves the robot, and
  /// `poll_hold` or the effector will give the answer; false: it is for the effector.
  bool accept_of_task(const RobotCommand& command, std::uint64_t number, Tick now) noexcept;
  /// Lets the robot hold for a late motion of the task when the operator's has ended. Call it after every wake-up.
  /// True: that is refused, and `reply` is the answer to the task.
  bool hold_for_late_motion(Reply& reply) noexcept;
  /// The answer to a hold or query of the task when it is due.
  bool poll_hold(Tick now, Reply& reply) noexcept;
  /// Takes command number `number` of the operator. True: `reply` is the answer; false: `take` will give it.
  bool accept(const RobotCommand& command, std::uint64_t number, Tick now, Reply& reply) noexcept;
  /// Takes a reply of the effector to an own number. True: `reply` is now the answer to a command of the operator.
  bool take(Reply& reply) noexcept;

 private:
  static constexpr std::uint64_t kOwn = std::uint64_t{1} << 63;

  enum class Phase { idle, jog, travel, stop, yielded, change };

  ErrorReport refusal(const RobotCommand& command, Tick now) const noexcept;
  ErrorReport jog(const RobotCommand& command, Tick now) noexcept;
  ErrorReport begin(const ErrorReport& error) noexcept;
  ErrorReport travel(const RobotCommand& command, std::uint64_t number) noexcept;
  ErrorReport next_jog_step(Tick begin) noexcept;
  RobotCommand with_one_output(const RobotCommand& command) noexcept;
  ErrorReport next_travel_step() noexcept;
  void stop() noexcept;
  /// Brakes what moves; a travel that waits for rest will not begin.
  void end_motion() noexcept;
  /// Passes a macrostep to the effector.
  ErrorReport send(const RobotCommand& command) noexcept;
  void answer(std::uint64_t number, const ErrorReport& error, Reply& reply) noexcept;
  Tick ticks(double seconds) const noexcept;

  Effector& effector_;
  const ModelSet& models_;
  const double period_;
  OperatorTravel travel_;
  Phase phase_ = Phase::idle;
  std::uint64_t sent_ = 0;  // own number of the last command to the effector
  std::optional<Tick> task_commands_until_, task_holds_until_;
  struct TaskHold {
    std::uint64_t number = 0;
    Tick due = 0;
    bool until_rest = false;  // instead: a query
  };
  bool begins_ = false;                // the effector had two macrosteps already
  std::optional<TaskHold> task_hold_;  // without an answer so far
  struct LateMotion {
    RobotCommand hold;  // executed instead
    std::uint64_t number = 0;
  };
  std::optional<LateMotion> late_motion_;
  struct NextTravel {
    RobotCommand command;
    std::uint64_t number = 0;
    bool ended = false;  // before it began
  };
  std::optional<NextTravel> next_travel_;  // begins at rest
  RobotCommand velocity_;                  // of the jog
  Tick valid_until_ = 0;
  std::optional<std::uint64_t> awaited_;  // the operator's number of the travel or change under way
  RobotCommand step_;
  Reply ignored_;
};

}  // namespace mrroc::edp
