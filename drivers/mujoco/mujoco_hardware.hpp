#pragma once

#include <cstdint>

#include "edp/servo/encoders.hpp"
#include "mrroc/robot_model.hpp"
#include "world/world_memory.hpp"

namespace mrroc::edp {

/// The drives of a robot in the simulated world. MuJoCo simulates the links only; the motors are simulated here, seen
/// from the joints through the transmission m(q), G = dm/dq (J, b: diagonal rotor inertias and viscous frictions, k_t:
/// torque constants, i: currents):
///
///   tau = G^T k_t i,   B = G^T J G,   D = G^T b G,   c = G^T J (dG/dt) dq/dt,
///
/// from J dw/dt = k_t i - b w - (torque to the gears) at w = G dq/dt. dG/dt is the central difference of G along dq/dt.
/// B is up to 158^2 times a rotor: more than the links themselves, so it may not be left out.
///
/// Drives that regulate on their own are simulated in the world (`sim::JointServo`): they get the set-points, and their
/// torques are measured as the currents that cause them.
///
/// The controller's terminals are wired to the world by name (`sim::ControllerWiring`).
///
/// `Encoders` computes positions from the shafts. Currents follow the regulator at once, cut at current_max.
/// Disabled, the brakes hold.
class MujocoHardware : public Hardware {
 public:
  enum class Timing {
    lockstep,  ///< the clock ensures that the world has reached the servo's tick
    real,      ///< `read` waits for the world, as a fieldbus master does for its slaves
    newest     ///< `read` takes the newest measurement of any tick: a drive that its bus polls
  };

  /// Robot slot `slot` of `memory`; both references must outlive this object. `patience`: timeout of `read`, s.
  MujocoHardware(const RobotModel& model, world::WorldMemory& memory, std::size_t slot, Timing timing,
                 bool synchronised = true, double patience = world::kPatienceWithWorld);

  /// The world is ready before the first tick: the start-up barrier waits for it.
  void open() override {}
  /// The world brakes or releases with the next `write`.
  void enable(bool on) noexcept override { enabled_ = on; }
  /// The world waits for the drives of every tick.
  bool waits() const noexcept override { return true; }
  bool follows_current() const noexcept override { return !drives_.regulate_themselves(); }
  void set_points(const JointVector& position, const JointVector& velocity) noexcept override;
  /// Fault `hardware_silent`: the world has not reached the tick (then the last motor positions are returned); in real
  /// time there is no further wait before it has continued. `drive_fault`: the joints are where the transmission cannot
  /// reach.
  void read(Tick tick, HardwareInput& input) noexcept override;
  void write(Tick tick, const JointVector& current) noexcept override;
  void set_outputs(const ControllerIo& outputs) noexcept override { outputs_ = outputs; }
  void set_origin(const JointVector& shift) noexcept override { encoders_.set_origin(shift); }

 private:
  bool await(Tick tick, world::JointMeasurement& measurement) noexcept;
  void measure_torques(const world::JointMeasurement& measurement) noexcept;
  void write_currents(const JointVector& current, world::JointDrive& drive) noexcept;
  void write_set_points(world::JointDrive& drive) const noexcept;

  const RobotModel& model_;
  const DriveParameters drives_;
  world::WorldMemory& memory_;
  std::size_t slot_;
  Timing timing_;
  std::int64_t patience_ns_;
  Encoders encoders_;
  bool enabled_ = false;
  bool silent_ = false;    ///< the last wait timed out
  Tick silent_since_ = 0;  ///< the world's tick then
  ControllerIo outputs_;
  JointVector shafts_, current_;             ///< as last known, as last commanded
  JointVector joints_, velocity_;            ///< as last measured
  JointVector set_position_, set_velocity_;  ///< of the shafts
};

}  // namespace mrroc::edp
