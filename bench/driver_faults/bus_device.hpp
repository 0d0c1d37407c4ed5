#pragma once

#include <functional>

#include "driver_faults/device.hpp"
#include "drivers/socketcan/can_rig.hpp"

namespace mrroc::driver_faults {

/// A gantry whose simulated drives and CiA 401 node are on a bus of Unix sockets. Its ticks follow one another as fast
/// as the bus answers; the nodes' time is that of the ticks.
class BusDevice final : public Device {
 public:
  BusDevice();

  const RobotModel& model() const override { return model_; }
  edp::Hardware& hardware() override { return hardware_; }
  edp::RobotTicker::Place wait_next() override;
  /// As the servo measures it.
  double speed(const edp::Snapshot& seen) override;

  /// Calls `action` with the I/O node.
  void with_node(const std::function<void(sim::IoNode&)>& action);

 private:
  edp::Gantry model_;
  config::DriveTable drives_;
  config::IoTable io_;
  edp::TestBus bus_;
  edp::Rack rack_;
  edp::CanHardware hardware_;
  Tick tick_ = 0;
};

}  // namespace mrroc::driver_faults
