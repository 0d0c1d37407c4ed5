#pragma once

#include "edp/encoders.hpp"
#include "mrroc/robot_model.hpp"
#include "sim/world_memory.hpp"

namespace mrroc::edp {

/// The drives of a robot in the simulated world. MuJoCo knows the links only; the motors are here, seen from the joints
/// through the transmission m(q), G = dm/dq (J, b: diagonal rotor inertias and viscous frictions, k_t: torque
/// constants, i: currents):
///
///   tau = G^T k_t i,   B = G^T J G,   D = G^T b G,   c = G^T J (dG/dt) dq/dt,
///
/// from J dw/dt = k_t i - b w - (torque to the gears) at w = G dq/dt. dG/dt is the central difference of G along dq/dt.
/// B is up to 158^2 times a rotor: more than the links themselves, so it may not be left out.
///
/// The controller's terminals are wired to the world by name (`sim::Terminals`).
///
/// Positions are what `Encoders` make of the shafts. Currents follow the regulator at once, cut at current_max.
/// Disabled, the brakes hold.
class MujocoHardware : public Hardware {
 public:
  /// How old a measurement may be before the world counts as silent.
  enum class Timing {
    lockstep,     ///< of the very tick
    free_running  ///< the simulator has its own timer: kSilence ticks
  };
  static constexpr Tick kSilence = 50;
  /// A free-running simulator may be late, which a drive's encoder never is: a measurement that is up to so many ticks
  /// old is carried on with its velocity.
  static constexpr Tick kCarriedOn = 10;

  /// Robot slot `slot` of `memory`; both references must outlive this object. `period` of the servo, s: for
  /// measurements that are late; 0: they are taken as they are.
  MujocoHardware(const RobotModel& model, sim::WorldMemory& memory, std::size_t slot, Timing timing,
                 bool synchronised = true, double period = 0);

  /// The world is there before the first tick: the start-up barrier waits for it.
  void open() override {}
  /// The world brakes or releases with the next `write`.
  void enable(bool on) noexcept override { enabled_ = on; }
  /// Fault `hardware_silent`: no measurement, or one that is too old (then the last known motors are given);
  /// `drive_fault`: the joints are where the transmission cannot reach.
  void read(Tick tick, HardwareInput& input) noexcept override;
  void write(Tick tick, const JointVector& current) noexcept override;
  void set_outputs(const Signals& outputs) noexcept override { outputs_ = outputs; }
  void set_origin(const JointVector& shift) noexcept override { encoders_.set_origin(shift); }

 private:
  const RobotModel& model_;
  sim::WorldMemory& memory_;
  std::size_t slot_;
  Timing timing_;
  double period_;
  Encoders encoders_;
  bool enabled_ = false;
  Signals outputs_;
  JointVector shafts_, current_;   ///< as last known, as last commanded
  JointVector joints_, velocity_;  ///< as last measured
};

}  // namespace mrroc::edp
