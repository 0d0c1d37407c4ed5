#pragma once

#include <cstdint>

#include "mrroc/errors.hpp"
#include "mrroc/fixed_text.hpp"
#include "mrroc/signals.hpp"
#include "mrroc/types.hpp"

namespace mrroc {

/// f_E as reported by a robot or a sensor in its reply; class `none` when all is well.
struct ErrorReport {
  ErrorClass error_class = ErrorClass::none;
  ErrorCode code = ErrorCode::none;
  FixedText<191> detail;
};

/// How the ECP of a robot took part in the command that a state answers, equation (11).
enum class Coordination : std::uint8_t {
  none = 0,        ///< not: the state is the EDP's
  takes_part = 1,  ///< the ECP has computed the robot's command from this one
  left = 2         ///< the ECP has left the Move without executing it: the sender plans again from this state
};

/// The part of a robot's state that its servo measures or holds itself, at the end of `tick`. Joint order and units are
/// the robot's.
struct MeasuredState {
  Tick tick = 0;
  JointVector joints;          ///< rad or m
  JointVector joint_velocity;  ///< rad/s or m/s
  JointVector motors;          ///< shaft positions, rad
  JointVector current;         ///< drive current, A
  /// Kinematic model in use: its index in the robot's list; 255: the robot is not synchronised. Its joints are then the
  /// motor shafts, counted from their position at power-on, and poses are meaningless.
  std::uint8_t model = 0;
  /// The wrench of the environment on the tool, in tool axes about the tool frame's origin, N and N m; zero without a
  /// force sensor in the deployment or before its first reading.
  Wrench wrench = Wrench::Zero();
  /// The fraction, 0..1, of the force law's twist at `tick` that a force motion near a singularity does not follow
  /// (docs/explanation/force.md); 0 elsewhere and in every other motion.
  double lost = 0;
  ControllerIo inputs;          ///< of the robot's controller, at `tick`
  ControllerIo outputs;         ///< as set
  std::uint8_t regulators = 0;  ///< regulator set in use: its index in RobotParameters::regulators, 0: the robot's own
  bool synchronised = false;
};

/// e^i of one effector as its EDP reports it. Measured values belong to `tick`; desired values to `desired_tick`, the
/// end of the macrostep (or stop) that is under way, equal to `tick` when the robot rests. Generators plan from
/// desired. Poses are of the tool frame in the robot's base frame.
struct RobotState : MeasuredState {
  Pose pose = Pose::Identity();  ///< direct kinematics of `joints`
  Tick macrostep_start = 0;      ///< tick 0 of the macrostep that this answers; of a query, the last one's
  Tick desired_tick = 0;
  JointVector desired_joints;
  JointVector desired_velocity;
  JointVector desired_acceleration;
  Pose desired_pose = Pose::Identity();
  Pose tool = Pose::Identity();  ///< tool frame in use, in the flange frame
  bool enabled = false;
  Coordination coordination = Coordination::none;
  std::uint32_t late_commands = 0;  ///< commands that arrived after the robot had begun to brake, since start
  ErrorReport error;

  /// The desired state at `desired_tick` does not move. Exact, because commands and stops that end at rest do so
  /// exactly.
  bool at_rest() const noexcept {
    return (desired_velocity.array() == 0.0).all() && (desired_acceleration.array() == 0.0).all();
  }
};

}  // namespace mrroc
