#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <vector>

#include "can/bus.hpp"
#include "edp/hardware.hpp"
#include "sim/can/drive_node.hpp"
#include "sim/can/io_node.hpp"

namespace mrroc::sim {

/// The simulated drives of one robot on a bus, and their motors: those of the simulated world or of a plant model. In
/// each cycle, that is at each SYNC, it reads the plant, lets every node answer, takes the nodes' set-points and writes
/// the plant's currents. Real drives measure at the SYNC, but the plant has its own ticks: a shaft is extrapolated to
/// the SYNC with its last velocity. One relay controls the brakes of all axes: they open while every drive has power.
/// Under the real clock, when a SYNC is missing while a motor has power, the cycle runs without it after two periods,
/// because drives continue. In simulated time a cycle ends when all set-points have come, or at the fence of its master
/// (`can::Fence`), which is returned.
///
/// The I/O nodes on the same bus measure the plant's inputs at each SYNC, and send them before the drives answer; the
/// plant gets their outputs with the currents.
///
/// One thread serves it; any other thread may call `stop` and inject faults with `with`.
class DriveRack {
 public:
  struct Newest {
    Tick tick = 0;
    double age = 0;  ///< periods since `tick`
  };
  /// The plant's newest tick. With `wait` it waits for one later than `last`, if that can still come. `now`: time of
  /// the SYNC, ns of wall time; the age refers to it.
  using PlantTick = std::function<Newest(Tick last, bool wait, std::int64_t now)>;
  /// The drives' own time: wall time, or the plant's ticks in simulated time.
  enum class Time { wall, plant };
  /// One cycle, before the nodes answer its SYNC.
  struct Cycle {
    Tick tick = 0;         ///< of the plant
    std::int64_t now = 0;  ///< the nodes' time, ns
    std::vector<DriveNode>& drives;
    std::vector<IoNode>& io_nodes;
    ControllerIo& inputs;  ///< the plant's, which the I/O nodes measure next
  };
  using AtCycle = std::function<void(const Cycle& cycle)>;

  /// `bus`, `plant` must outlive it. `period` in s. `io`: the I/O nodes.
  DriveRack(const config::DriveTable& table, const RobotParameters& robot, double period, can::Bus& bus,
            edp::Hardware& plant, PlantTick plant_tick, Time time, AtCycle at_cycle = {},
            const config::IoTable& io = {});

  /// Powers the drives on, then serves until `stop`. Throws the exceptions of the plant.
  void serve();
  void stop() noexcept { stop_.store(true); }

  /// Calls a function with the nodes between two frames. Any thread but the serving one.
  void with(const std::function<void(std::vector<DriveNode>&)>& action);
  /// The same with the I/O nodes.
  void with_io(const std::function<void(std::vector<IoNode>&)>& action);
  /// Whether some motor has power. Any thread.
  bool powered() const noexcept { return powered_.load(); }
  /// SYNCs served so far. Any thread.
  std::uint64_t cycles() const noexcept { return cycles_.load(); }

 private:
  std::int64_t now() const noexcept;
  void take(const can::Frame& frame);
  void begin_cycle(bool on_bus);
  void measure();
  void drive();
  bool all_commanded() const noexcept;
  bool any_powered() const noexcept;

  can::Bus& bus_;
  edp::Hardware& plant_;
  PlantTick plant_tick_;
  Time time_;
  canopen::NodeId master_;
  std::uint32_t sync_;  ///< identifier of its SYNC
  AtCycle at_cycle_;
  std::int64_t period_;  ///< ns
  std::vector<DriveNode> nodes_;
  std::vector<IoNode> io_nodes_;
  edp::HardwareInput input_;
  JointVector per_period_;   ///< that the shafts have turned, rad
  Tick tick_ = 0;            ///< of the plant, in this cycle
  bool let_go_ = false;      ///< the brakes are open
  bool open_ = false;        ///< the cycle's currents are not written yet
  std::int64_t synced_ = 0;  ///< when the last cycle began, ns of wall time
  std::mutex mutex_;
  std::atomic<bool> stop_{false};
  std::atomic<bool> powered_{false};
  std::atomic<std::uint64_t> cycles_{0};
};

}  // namespace mrroc::sim
