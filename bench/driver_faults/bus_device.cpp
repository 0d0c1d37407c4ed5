#include "driver_faults/bus_device.hpp"

namespace mrroc::driver_faults {

namespace {

/// A node with 8 digital inputs and 8 digital outputs.
config::IoTable one_node() {
  config::IoTable table;
  table.file = "io";
  config::IoEntry& node = table.nodes.emplace_back();
  node.node = 40;
  node.digital_inputs = node.digital_outputs = {0, 8};
  node.eds = canopen::EdsFile::load(MRROC_SOURCE_DIR "/src/canopen/cia401.eds");
  return table;
}

}  // namespace

BusDevice::BusDevice()
    : drives_(edp::table_for(model_.parameters(), canopen::DriveMode::cyclic_position)),
      io_(one_node()),
      rack_(drives_, model_, bus_, true, kPeriod, io_),
      hardware_(drives_, model_.parameters(), kPeriod, bus_.opener(), edp::kTestTiming, true, io_) {
  hardware_.open();
}

edp::RobotTicker::Place BusDevice::wait_next() {
  const Tick tick = tick_++;
  return {tick, 0, static_cast<double>(tick)};
}

double BusDevice::speed(const edp::Snapshot& seen) {
  return seen.joint_velocity.size() == 0 ? 0 : seen.joint_velocity.cwiseAbs().maxCoeff();
}

void BusDevice::with_node(const std::function<void(sim::IoNode&)>& action) {
  rack_.with_io([&action](std::vector<sim::IoNode>& nodes) { action(nodes.front()); });
}

}  // namespace mrroc::driver_faults
