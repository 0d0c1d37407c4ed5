#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/milling.hpp"
#include "sim/scene/controller_wiring.hpp"
#include "sim/scene/driven_joints.hpp"
#include "sim/scene/free_body.hpp"
#include "sim/scene/model.hpp"
#include "sim/scene/mujoco_messages.hpp"
#include "sim/scene/weld_torques.hpp"

namespace mrroc::sim {

/// A warning of MuJoCo's, with the tick in which it first came and the number of times that it came.
struct WorldWarning {
  std::string text;
  Tick first_tick = 0;
  std::uint64_t count = 0;
};

/// One MuJoCo world with the robots that are driven from outside, stepped tick by tick.
///
/// A physics step of h seconds (semi-implicit Euler) is MuJoCo's own sequence with the drives between (see
/// `DrivenJoints`); it ends with the position and velocity stages of the *new* state, so that positions, and the values
/// of range, position and velocity sensors belong to the tick that `step` names. Force and acceleration sensors read
/// what acted during its last physics step.
///
/// Bitwise deterministic on one machine. `step` allocates nothing. One thread at a time.
class World {
 public:
  /// `period` is a whole number of `timestep`s (s). Throws config::ConfigurationError when MuJoCo rejects the world or
  /// the scene names another integrator than Euler, SystemError without memory.
  World(const Composition& composition, double period, double timestep);

  /// Adds a driven robot and places it at `home`, brakes on; returns its index. Before `start`. Throws as DrivenJoints.
  std::size_t attach(const std::string& robot, const std::vector<std::string>& joints, const JointVector& home);
  /// Holds a free body of the scene where it is, without weight and contacts, until `put`; returns its index.
  /// Before `start`. Throws as FreeBody.
  std::size_t hold(const std::string& body, const std::string& key);
  /// Computes positions, forces and sensors of tick 0, with all brakes on.
  void start();

  /// Sets the drive of robot `index` for the next `step`. Throws SystemError (simulator): not finite, or coupling
  /// joints of different branches.
  void drive(std::size_t index, const world::JointDrive& drive, Tick tick);
  void brake(std::size_t index);
  /// Sets the Coulomb friction of robot `index`'s joints, N m or N, until its brakes engage.
  void set_friction(std::size_t index, const std::array<double, kMaxJoints>& friction) noexcept;
  /// Advances from tick - 1 to `tick`. Throws SystemError (simulator) with the tick and the cause: MuJoCo met a
  /// bad position, velocity, acceleration or control (and has reset the world), its contact or constraint buffers are
  /// full, an inertia is singular, or time did not advance. The world is of no use afterwards.
  void step(Tick tick);

  /// Puts the held body `index` at `pose` in the world, at rest and from now on free. Sensors see it from the next tick
  /// on.
  void put(std::size_t index, const Pose& pose);
  /// Sets the outputs of robot `index`'s controller.
  void set_outputs(std::size_t index, const ControllerIo& outputs) noexcept;
  /// Joints and inputs.
  void measure(std::size_t index, world::JointMeasurement& measurement) const noexcept;
  const mjModel& model() const noexcept { return *model_; }
  /// The cutter of the scene, if it has one.
  const std::optional<Milling>& milling() const noexcept { return milling_; }
  const mjData& data() const noexcept { return *data_; }
  /// For tests and scripts that act on the world itself: controls, poses of objects.
  mjData& data() noexcept { return *data_; }
  /// MuJoCo's warnings so far, each once.
  const std::vector<WorldWarning>& warnings() const noexcept { return warnings_; }

 private:
  void evaluate_motion();
  void evaluate_forces();
  void check(double time_before, Tick tick) const;
  void remember(const std::string& warning, Tick tick);

  Model model_;
  Data data_;
  int substeps_;
  WeldTorques weld_torques_;
  std::optional<Milling> milling_;
  std::vector<DrivenJoints> robots_;
  std::vector<ControllerWiring> terminals_;
  std::vector<FreeBody> held_;
  std::vector<WorldWarning> warnings_;
};

}  // namespace mrroc::sim
