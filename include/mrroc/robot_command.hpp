#pragma once

#include <algorithm>

#include "mrroc/common_stop.hpp"
#include "mrroc/force_law.hpp"
#include "mrroc/load.hpp"
#include "mrroc/signals.hpp"
#include "mrroc/types.hpp"

namespace mrroc {

/// The action that a command requests.
enum class CommandKind : std::uint8_t {
  query = 0,           ///< GET: report the state at once, change nothing
  hold = 1,            ///< e^{i+1} = e^i: come to rest (within the limits) and stay there
  joint = 2,           ///< reach `joints` with `joint_velocity` at the end of the macrostep
  pose = 3,            ///< reach `pose` with `twist` at the end of the macrostep
  motor = 4,           ///< as `joint`, but every value is of the motor shafts (rad)
  joint_velocity = 5,  ///< change to `joint_velocity` as fast as the limits allow and keep it
  twist = 6,           ///< change to the joint velocities that give the tool `twist` and keep them
  force = 7,  ///< follow `force` with the velocity `twist` in tool axes, tick by tick, until the macrostep ends
  // one exchange each, of a robot at rest (Robot::set_tool, use_model, ...); set_outputs at any time
  set_tool = 8,         ///< `pose` is the tool frame in the flange frame from now on
  use_model = 9,        ///< the kinematic model `choice` from now on
  synchronise = 10,     ///< find the absolute positions of the motors
  recover = 11,         ///< clear a fault and switch the drives on, at the measured position
  bias_force = 12,      ///< take the force sensor's present reading as zero, for the force law and the force limits
  use_regulators = 13,  ///< the regulator set `choice` from now on
  set_outputs = 14,     ///< `outputs` from the next tick on
  carry = 15,           ///< the tool carries `load` from now on: the force law and the force limits take its weight off
  end = 16              ///< to an ECP that takes part in a Move of the MP: it has ended. An EDP refuses it
};

/// The space in which the path to the end of the macrostep is smooth: a polynomial of degree five in time from the
/// position, velocity and acceleration at its start to those at its end.
enum class Interpolation : std::uint8_t {
  joints = 0,
  motors = 1,
  task = 2  ///< of the tool's position and rotation vector: straight if the end states are
};

/// e^{i+1} for one effector: one macrostep of N servo ticks (the original's motion_steps and value_in_step_no).
///
/// The macrostep begins where the previous one's desired state ends (or at the end of a stop), at tick
/// max(start_tick, end of the previous macrostep, present tick), and ends N ticks later; its first new set-point is
/// that of its tick 1, so a command after a reply at v = N still continues without a gap. The EDP replies at tick v; v
/// = N + 1 is the first tick after the macrostep. A command with a nonzero end velocity needs a successor: if it does
/// not arrive in time, the EDP brakes within the limits, holds, and counts a late command: as `stop` says, where that
/// keeps the limits from the end of a `joint`, `motor` or `pose` macrostep, else every joint on its own. A late command
/// with a `stop` is a `hold`, so that robots that have braked in step stay so; their sender plans again.
///
/// A `hold` in motion executes N ticks of a stop. The stop continues with the next `hold` or without a successor; any
/// other command takes over from there. With v = N + 1 the `hold` lasts as long as the stop.
///
/// The end of a `force` motion is not known in advance. Another `force` command continues it; any other command is
/// planned from the end of a stop after it, and takes longer instead of being refused. The EDP scales the joint
/// velocities of the law down together to the limits. It stops the robot, with a non-fatal error, before a stop would
/// exceed the position limits.
///
/// Position, velocity, acceleration and jerk of every joint must stay within the robot's limits at every tick of the
/// path; otherwise the command is refused.
struct RobotCommand {
  CommandKind kind = CommandKind::query;
  /// `joints` / `pose` are increments on the *desired* state at the macrostep's start; a pose increment is in tool
  /// axes: target = desired * pose. A relative `twist` command is in tool axes.
  bool relative = false;
  Interpolation interpolation = Interpolation::joints;  ///< of `joint`, `motor` and `pose`
  std::uint16_t motion_steps = 10;                      ///< N, 1..kMaxMotionSteps
  std::uint16_t reply_step = 8;                         ///< v, 1..N+1
  Tick start_tick = 0;                                  ///< tick 0 of the macrostep; 0: as soon as possible
  JointVector joints;                                   ///< rad or m
  JointVector joint_velocity;                           ///< rad/s or m/s at the end; empty: at rest
  JointVector joint_acceleration;                       ///< rad/s^2 or m/s^2 at the end; empty: the macrostep's mean
  Pose pose = Pose::Identity();                         ///< of the tool frame in the robot's base frame
  Twist twist = Twist::Zero();                          ///< of the tool frame's origin at the end, in base axes
  JointVector twist_acceleration;                       ///< d twist / dt at the end, 6 values; empty: the mean
  ForceLaw force;                                       ///< of `force`
  CommonStop stop;                                      ///< without a successor; set by Move for several robots
  Load load;                                            ///< of `carry`; centre in the tool frame
  std::uint8_t choice = 0;                              ///< of `use_model`, `use_regulators`: index in the robot's list
  bool with_outputs = false;                            ///< of a motion: `outputs` from the macrostep's tick 0 on
  ControllerIo outputs;

  /// Tick 0 of the macrostep, when the one before ends at tick `end` and the command arrives at tick `now`.
  Tick first_tick(Tick end, Tick now) const noexcept { return std::max({start_tick, end, now}); }
  /// The tick of the reply, then.
  Tick reply_tick(Tick end, Tick now) const noexcept { return first_tick(end, now) + reply_step; }
};

inline constexpr std::uint16_t kMaxMotionSteps = 10000;

}  // namespace mrroc
