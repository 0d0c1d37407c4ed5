#pragma once

#include <array>
#include <optional>

#include "edp/check/model_set.hpp"
#include "edp/command/planner.hpp"
#include "edp/command/servo_channel.hpp"
#include "mrroc/robot_command.hpp"
#include "mrroc/robot_state.hpp"
#include "mrroc/tool_kinematics.hpp"

namespace mrroc::edp {

/// Whether a command changes the robot instead of moving it. Unknown kinds do, and are refused.
constexpr bool is_change(CommandKind kind) noexcept { return kind >= CommandKind::set_tool; }

/// The answer to one command.
struct Reply {
  std::uint64_t command = 0;  ///< the number that `accept` was given
  RobotState state;
};

/// The comms side of one robot, without any transport: takes commands, passes macrosteps to the servo, gives replies.
/// Every command is answered exactly once: by `accept` at once (queries and errors) or by `poll` at its tick v.
///
/// A command is planned from the desired state at the end of all that was accepted before. One may run and one may wait
/// for it (pipelining); a third is refused with `busy`. A start tick after the end of a motion that does not end at
/// rest lets the robot stop first.
///
/// Late: a command is late when the robot has begun to brake without it, that is when it was computed from a state
/// before the braking. It is counted, planned from the end of the stop, and takes longer instead of being refused where
/// the limits demand it. A reply that reports the stop ends this: later commands are computed from the stop.
///
/// A command after a force motion, other than its continuation, waits for the stop after it and is planned then.
///
/// An interrupted motion is answered with the servo's error, at once if its reply is still due; otherwise the next
/// command is, because its sender computed it without that error.
///
/// After a fault or `enable(false)` motions are refused, and every reply carries a latched fault as a hardware error,
/// until `enable(true)` or a `recover` command. A robot that is not synchronised takes relative motor motion,
/// `joint_velocity` with the interpolation `motors`, hold and `synchronise`; its joints are then the shafts.
///
/// `set_tool` is answered at once, `use_model` when the servo has changed, `synchronise` when it is done, `recover`
/// when the drives are on or the fault has come back. The first three require a motion that ends at rest, and follow
/// it.
///
/// One thread (any, but always the same one); allocates only in the constructor, never throws, never waits.
class Effector {
 public:
  /// `period` in s. `models` must outlive it. Throws SystemError when an axis has no acceleration or jerk limit.
  Effector(const ModelSet& models, double period, ServoChannel& hand_over);

  /// The robot has a force sensor, whose frame is at `mount` in the flange frame. Before the first command.
  void use_force_sensor(const Pose& mount) noexcept { mount_ = mount; }

  /// A motion of the task that is not executed, because the robot is no longer where the task left it.
  void count_late_command() noexcept { ++counters_.late; }
  /// Whether a motion can be taken now: one may run and one wait.
  bool has_place() noexcept {
    refresh();
    return free_place() != nullptr;
  }
  /// Takes command number `number` (the caller's, for the reply). True: `reply` is the answer; false: `poll` will give
  /// it. Call `poll` until false before; in lockstep, both after the servo's tick.
  bool accept(const RobotCommand& command, std::uint64_t number, Reply& reply) noexcept;

  /// The next reply that is due; false when no reply is due. Call until false whenever the servo's tick returned true.
  bool poll(Reply& reply) noexcept;

  /// Switches the drives on (clearing a fault that is over) or stops the robot and switches them off, from the servo's
  /// next tick on.
  void enable(bool on) noexcept;

  /// The state as a query would report it, for telemetry; false before the servo's first tick. Reports nothing.
  bool peek(RobotState& state) noexcept;

  const CommandCounters& counters() const noexcept { return counters_; }
  /// The last snapshot of the servo; null before its first tick. Valid until the next call of this object.
  const Snapshot* snapshot() noexcept {
    refresh();
    return snapshot_;
  }

 private:
  struct Outstanding {
    bool used = false;
    bool replied = false;
    bool late = false;
    bool after_force = false;         ///< planned from a stop of which its sender had no report
    std::uint32_t interruptions = 0;  ///< reported to its sender
    std::uint32_t epoch = 0;          ///< when its macrostep was handed over
    std::uint64_t ticket = 0;
    std::uint64_t number = 0;
    RobotCommand command;
    Tick start = 0, end = 0;  ///< of its macrostep as planned, or as the servo reported
  };

  void refresh() noexcept;
  ErrorReport take_outputs(const ControllerIo& outputs) noexcept;
  ErrorReport refuse(const RobotCommand& command) noexcept;
  ErrorReport refusal(const RobotCommand& command) const noexcept;
  ErrorReport refusal_of_outputs(const ControllerIo& outputs) const noexcept;
  ErrorReport refusal_of_change(const RobotCommand& command) const noexcept;
  void use_model() noexcept;
  bool poll_recovery(Reply& reply) noexcept;
  Outstanding* free_place() noexcept;
  ErrorReport hand_over(Outstanding& entry) noexcept;
  void begun(Outstanding& entry, Tick start) noexcept;
  void fill(const Snapshot& snapshot, const DesiredState& end, Tick end_tick, RobotState& state) const noexcept;
  void fill_present(RobotState& state) const noexcept;
  void answer(std::uint64_t number, const ErrorReport& error, Reply& reply) noexcept;

  /// A `recover` command without an answer so far.
  struct Recovery {
    bool under_way = false;
    std::uint64_t number = 0;
    std::uint32_t orders = 0;  ///< the snapshot's count before it
  };

  const ModelSet& models_;
  ServoChannel& channel_;
  Planner planner_;
  std::uint8_t model_ = 0;  ///< that the planner uses
  Pose tool_;
  std::optional<Pose> mount_;  ///< of the force sensor
  std::uint32_t interruptions_told_ = 0;
  Recovery recovery_;
  const Snapshot* snapshot_ = nullptr;  ///< the newest; null before the servo's first tick
  std::uint32_t epoch_ = 0;
  DesiredState end_;         ///< of all that has been accepted
  Tick end_tick_ = 0;        ///< when
  bool holding_ = false;     ///< the last accepted macrostep is a hold: it may end before the stop does
  bool forced_ = false;      ///< the last accepted motion of this epoch is one of force: `end_` is not known
  bool unreported_ = false;  ///< the robot has braked and no reply has reported it yet
  bool joined_ = false;      ///< it has braked because another robot of its motion had stopped, not reported either
  std::array<Outstanding, 2> outstanding_{};
  std::uint64_t last_ticket_ = 0;
  Tick macrostep_start_ = 0;  ///< of the last one that was answered
  Macrostep stop_;            ///< scratch: too large for a small stack
  Macrostep macrostep_;
  CommandCounters counters_;
};

}  // namespace mrroc::edp
