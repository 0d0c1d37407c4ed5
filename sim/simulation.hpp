#pragma once

#include <optional>
#include <vector>

#include "config/deployment.hpp"
#include "sim/errors/delayed_snapshots.hpp"
#include "sim/errors/faulty_readings.hpp"
#include "sim/errors/faulty_transmission.hpp"
#include "sim/feeder.hpp"
#include "sim/flange_sensor.hpp"
#include "sim/sensors.hpp"
#include "sim/state_file.hpp"
#include "sim/world.hpp"
#include "world/world_memory.hpp"

namespace mrroc::sim {

/// The world of a deployment as text: its scene and every robot whose hardware is `mujoco`, with the errors of
/// [sim.errors]. Throws
/// config::ConfigurationError.
Composition compose(const config::Deployment& deployment);
/// For a view of all robots, whatever their hardware; without [sim] in an empty world.
Composition compose_all(const config::Deployment& deployment);

/// The simulated world of one deployment, tied to the memory through which drivers and VSPs reach it. Slot i of
/// `drives` and `measurements` is deployment.robots[i] (unused for other hardware than `mujoco`), slot j of `readings`
/// deployment.sensors[j] (unused for other sources than `simulated`). A simulated sensor whose type has the parameter
/// `camera` views the world itself: it needs no MJCF sensor, and `snapshot` is stored for it at every tick. Slot i of
/// `flanges` is that of a simulated robot whose controller is a sensor of the deployment.
///
/// One thread. `step` allocates nothing.
class Simulation {
 public:
  /// Like the watchdog of a real drive that misses its cyclic set-point.
  static constexpr Tick kDriveLifetime = 5;

  /// Builds the world with each robot at its home. `memory` must outlive this object. Throws config::ConfigurationError
  /// (no [sim], broken scene, joints or sensors that the MJCF does not have) or SystemError (no memory).
  Simulation(const config::Deployment& deployment, world::WorldMemory& memory);

  /// Stores the measurements and readings of tick 0.
  void publish_initial();
  /// Lets the feeders put their parts, reads the drives, advances the world from tick - 1 to `tick`, stores its
  /// measurements and readings. Brakes hold a robot that has no drive yet, a disabled one, or one older than
  /// kDriveLifetime ticks: its EDP is gone. An EDP with drives on a bus ends its tick after they have acted
  /// (`can::Fence`). Throws SystemError (simulator), see World::step.
  void step(Tick tick);
  /// Real time: `step`, but not before every robot's drive of tick - 1 has come, as in lockstep. A robot whose brakes
  /// are on is not waited for; one that keeps the world waiting for `patience` (s of wall time) is braked, and the
  /// world continues without it until it drives again.
  void step_in_real_time(Tick tick, double patience = world::kPatienceWithDrives);

  /// Whether any robot's drive acted in the last step: if not, all brakes are on.
  bool driven() const noexcept;

  /// The state for pictures by `mrroc_render`; `save_state` writes it to a file.
  WorldState state() const;
  World& world() noexcept { return world_; }
  const World& world() const noexcept { return world_; }

 private:
  struct Slot {
    std::size_t memory;                                ///< slot in world::WorldMemory
    std::size_t world;                                 ///< index of the robot in the world
    world::JointDrive drive{};                         ///< the newest
    Tick given_up = kNever;                            ///< tick of the drive after which the next did not come in time
    std::optional<FaultyTransmission> transmission{};  ///< with [sim.errors]
  };
  struct SensorSlot {
    std::size_t memory;
    SensorSource source;
    std::optional<FaultyReadings> errors{};  ///< with [sim.errors]
  };
  struct FlangeSlot {
    std::size_t memory;
    FlangeSensor sensor;
  };
  bool drives(const Slot& slot, Tick tick) const noexcept;
  bool is_due(Slot& slot, Tick tick) noexcept;
  void take_drive(Slot& slot, Tick tick);
  void publish(Tick tick);
  void store_snapshot(Tick tick) noexcept;

  world::WorldMemory& memory_;
  World world_;
  std::vector<Slot> robots_;
  std::vector<SensorSlot> sensors_;
  std::vector<FlangeSlot> flanges_;
  std::vector<Feeder> feeders_;
  bool looked_at_ = false;                   ///< some sensor uses the snapshot
  std::optional<DelayedSnapshots> delayed_;  ///< with cameras that are late
  bool may_be_watched_ = false;              ///< the world fits into one
  world::WorldSnapshot snapshot_{};          ///< the last one stored
  Tick tick_ = 0;
};

}  // namespace mrroc::sim
