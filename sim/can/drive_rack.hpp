#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <vector>

#include "can/bus.hpp"
#include "edp/hardware.hpp"
#include "sim/can/drive_node.hpp"

namespace mrroc::sim {

/// The simulated drives of one robot on a bus, and the motors that they drive: those of the simulated world or of a
/// plant model. In each cycle, that is at each SYNC, it reads the plant, lets every node answer, takes the nodes'
/// set-points and writes the plant's currents. Real drives measure when the SYNC comes, the plant has ticks of its own:
/// what a shaft has turned since is added, as fast as it was. The brakes of all axes hang on one relay: they let go
/// while every drive has power. A SYNC that does not come while a motor has power is made up for after two periods:
/// drives continue.
///
/// One thread serves it; `stop` and the nodes' faults may come from any other, under `with`.
class DriveRack {
 public:
  struct Newest {
    Tick tick = 0;
    double age = 0;  ///< periods that have gone by since `tick`
  };
  /// The plant's newest tick; with `wait` it waits for one later than `last`, where that is worth it. `now`: when the
  /// SYNC came, ns of the wall; the age is that of then.
  using PlantTick = std::function<Newest(Tick last, bool wait, std::int64_t now)>;
  /// Of the drives' own time: by the wall, or by the plant's ticks where that is simulated.
  enum class Time { wall, plant };
  /// What is to happen to the nodes at tick `tick` of the plant, before they answer its SYNC; `now`: their time, ns.
  using AtCycle = std::function<void(Tick tick, std::int64_t now, std::vector<DriveNode>& nodes)>;

  /// `bus`, `plant` must outlive it. `period` in s.
  DriveRack(const config::DriveTable& table, const RobotParameters& robot, double period, can::Bus& bus,
            edp::Hardware& plant, PlantTick plant_tick, Time time, AtCycle at_cycle = {});

  /// The power comes on, then serves until `stop`. Throws what the plant throws.
  void serve();
  void stop() noexcept { stop_.store(true); }

  /// Does something to the nodes between two frames. Any thread but the serving one.
  void with(const std::function<void(std::vector<DriveNode>&)>& action);
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
  AtCycle at_cycle_;
  std::int64_t period_;  ///< ns
  std::vector<DriveNode> nodes_;
  edp::HardwareInput input_;
  JointVector per_period_;   ///< that the shafts have turned, rad
  Tick tick_ = 0;            ///< of the plant, in this cycle
  bool let_go_ = false;      ///< the brakes
  bool open_ = false;        ///< the cycle's currents are still to be written
  std::int64_t synced_ = 0;  ///< when the last cycle began, ns of the wall
  std::mutex mutex_;
  std::atomic<bool> stop_{false};
  std::atomic<bool> powered_{false};
  std::atomic<std::uint64_t> cycles_{0};
};

}  // namespace mrroc::sim
