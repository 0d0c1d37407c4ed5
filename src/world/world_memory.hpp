#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

#include "clock/gate.hpp"
#include "core/lockfree/shared_slot.hpp"
#include "mrroc/raw_reading.hpp"
#include "mrroc/signals.hpp"
#include "mrroc/types.hpp"

namespace mrroc::world {

/// The simulated hardware's "bus": plain values in memory shared by the sim process, the EDPs' mujoco driver and the
/// VSPs' simulated source. Each value has one writer; `SharedSlot` makes reads untorn and wait-free for the writer, so
/// the same layout serves lockstep (where phases never overlap) and real time, where drives and measurements wait for
/// one another at the gates. The runner creates the memory (memfd, zeroed, inherited by its children), so no process
/// that dies leaves a file.

inline constexpr std::size_t kMaxRobots = 16;
inline constexpr std::size_t kMaxSensors = 32;
/// Positions and mocap poses of the largest world that a camera may show: robots' joints and some 100 free objects.
inline constexpr std::size_t kMaxSnapshotValues = 1024;

/// Real time: how long the simulator waits for an EDP's drive, then how long an EDP waits for the simulator, which may
/// itself be waiting for other EDPs; s of wall time.
inline constexpr double kPatienceWithDrives = 0.5;
inline constexpr double kPatienceWithWorld = 2.0;

/// EDP -> sim, every tick. Drives that follow a current, at the joints: M(q) + B is the inertia, tau - D dq/dt - c the
/// torque that the drives add. Drives that regulate on their own: their set-points (`sim::JointServo`).
struct JointDrive {
  enum class Kind : std::uint32_t { torque, position, velocity };
  Tick tick = 0;  ///< tick in which it was computed; 0: never attached
  std::uint32_t joint_count = 0;
  std::uint32_t enabled = 0;                ///< 0: brakes on
  ControllerIo outputs;                     ///< of the robot's controller, independent of the brakes
  std::array<double, kMaxJoints> torque{};  ///< tau = G^T (torque constant * current), N m or N
  std::array<double, kMaxJoints> bias{};    ///< c = G^T J dG/dt dq/dt
  std::array<double, kMaxJoints * kMaxJoints> rotor_inertia{};  ///< B = G^T J G, row major
  std::array<double, kMaxJoints * kMaxJoints> damping{};        ///< D = G^T b G, row major
  Kind kind = Kind::torque;
  std::array<double, kMaxJoints> position{};    ///< set-points at the beginning of the tick, rad or m
  std::array<double, kMaxJoints> velocity{};    ///< rad/s or m/s, during the tick
  std::array<double, kMaxJoints> torque_max{};  ///< N m or N
  double bandwidth = 0;                         ///< rad/s
};

/// sim -> EDP, every tick.
struct JointMeasurement {
  Tick tick = 0;
  std::array<double, kMaxJoints> position{};
  std::array<double, kMaxJoints> velocity{};
  std::array<double, kMaxJoints> torque{};  ///< of drives that regulate on their own, N m or N
  ControllerIo inputs;                      ///< of the robot's controller
};

/// sim -> the stand-in of a robot's controller that measures the load on its flange, every tick (`sim::FlangeLoad`).
struct FlangeMeasurement {
  Tick tick = 0;
  std::array<double, 3> position{};  ///< of the flange in the robot's base frame, m
  std::array<double, 9> rotation{};  ///< of its axes there, row major
  std::array<double, 6> load{};      ///< in its axes, about its origin: 3 forces (N), 3 torques (N m)
};

/// sim -> VSPs that render the world (cameras), every tick if there is one, and the runner while a client watches the
/// world (`WorldMemory::watched`): the state from which a picture is drawn.
/// The poses of bodies follow from it and the model, which every process composes from the deployment. An endless belt
/// is always at its origin here, independent of its travel.
struct WorldSnapshot {
  Tick tick = 0;
  std::uint32_t position_count = 0;
  std::uint32_t mocap_count = 0;  ///< bodies
  std::array<double, kMaxSnapshotValues>
      values{};  ///< MuJoCo's qpos, then mocap_pos (3 each), then mocap_quat (4 each)
};

/// The whole memory. Robot slot i is deployment.robots[i]; sensor slot j is deployment.sensors[j].
struct WorldMemory {
  std::array<core::SharedSlot<JointDrive>, kMaxRobots> drives;
  std::array<core::SharedSlot<JointMeasurement>, kMaxRobots> measurements;
  std::array<core::SharedSlot<FlangeMeasurement>, kMaxRobots> flanges;
  std::array<core::SharedSlot<RawReading>, kMaxSensors> readings;  ///< sim -> VSP, every tick
  core::SharedSlot<WorldSnapshot> snapshot;
  core::SharedSlot<WorldSnapshot> seen;   ///< the same as cameras with a latency see it: an older world at this tick
  std::atomic<std::uint32_t> watched{0};  ///< runner -> sim: not 0 while a client watches the snapshots
  clock::Gate driven;                     ///< real time: opened after each store into `drives`
  clock::Gate measured;                   ///< real time: opened when a tick's measurements and readings are stored
};

}  // namespace mrroc::world
