#include "config/drives/bus_load.hpp"

namespace mrroc::config {

namespace {

using canopen::DriveMode;

// bytes of the PDOs, drivers/socketcan/drive_setup.cpp; a test compares them
constexpr int kPositionCommand = 7, kVelocityCommand = 7, kTorqueCommand = 5;
constexpr int kFeedback = 8, kStatus = 8;
constexpr int kSync = 0, kHeartbeat = 1;

int command_of(DriveMode mode) {
  if (mode == DriveMode::cyclic_torque) return kTorqueCommand;
  return mode == DriveMode::cyclic_velocity ? kVelocityCommand : kPositionCommand;
}

/// Bits of the PDOs with the terminals of one kind, in one direction: digital ones in one PDO, four analogue ones each.
int terminal_bits(int digital, int analog) {
  int bits = digital > 0 ? frame_bits((digital + 7) / 8) : 0;
  for (int rest = analog; rest > 0; rest -= 4) bits += frame_bits(2 * (rest < 4 ? rest : 4));
  return bits;
}

}  // namespace

BusLoad bus_load(const DriveTable& drives, const IoTable& io, double period) {
  const auto axes = static_cast<double>(drives.drives.size());
  BusLoad load;
  load.cycle = frame_bits(kSync) + axes * (frame_bits(kFeedback) + frame_bits(command_of(drives.mode)));
  double status = axes * frame_bits(kStatus);
  double beats = static_cast<double>(drives.nodes() + 1 + io.nodes.size()) * frame_bits(kHeartbeat);
  for (const IoEntry& node : io.nodes) {
    status += terminal_bits(node.digital_inputs.count, node.analog_inputs.count);
    beats += terminal_bits(node.digital_outputs.count, node.analog_outputs.count);
  }
  load.per_second = (load.cycle + status / drives.status_every) / period + beats / drives.heartbeat;
  return load;
}

}  // namespace mrroc::config
