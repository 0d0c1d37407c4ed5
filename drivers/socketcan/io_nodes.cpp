#include "drivers/socketcan/io_nodes.hpp"

#include "edp/safety/stop_category.hpp"

namespace mrroc::edp {

using namespace canopen;

IoNodes::IoNodes(const config::IoTable& table, const config::DriveTable& drives, double period) {
  for (const config::IoEntry& entry : table.nodes) {
    nodes_.emplace_back(entry, drives, period);
    digital_outputs_ += entry.digital_outputs.count;
    analog_outputs_ += entry.analog_outputs.count;
  }
}

void IoNodes::add_filters(std::vector<can::Filter>& filters) const {
  for (const IoNode& node : nodes_) {
    for (const std::uint32_t function : {kEmergency, kSdoResponse, kHeartbeat})
      filters.push_back({function + node.node(), 0x7ff});
    for (std::uint32_t pdo = 0; pdo < IoPdos::kCount; ++pdo)
      for (const std::uint32_t first : {kTransmitPdo1, kReceivePdo1})
        filters.push_back({first + 0x100 * pdo + node.node(), 0x7ff});
  }
}

void IoNodes::read(Tick tick, HardwareInput& input) const noexcept {
  input.inputs = {};
  for (const IoNode& node : nodes_) {
    node.read(tick, input.inputs);
    const IoFault fault = node.fault(tick);
    if (std::holds_alternative<std::monostate>(fault) || !graver(ErrorCode::io_fault, input.fault)) continue;
    input.fault = ErrorCode::io_fault;
    input.fault_detail = describe(node.node(), fault);
  }
  if (missing_ == kNone || !graver(ErrorCode::io_fault, input.fault)) return;
  input.fault = ErrorCode::io_fault;
  const bool digital = missing_ < ControllerIo::kDigital;
  input.fault_detail = driver_text("no node has %s output %d, which is switched on", digital ? "digital" : "analogue",
                                   digital ? missing_ : missing_ - ControllerIo::kDigital);
}

void IoNodes::set_outputs(const ControllerIo& outputs) noexcept {
  outputs_ = outputs;
  for (int i = ControllerIo::kAnalog - 1; i >= analog_outputs_; --i)
    if (outputs.analog[static_cast<std::size_t>(i)] != 0) missing_ = ControllerIo::kDigital + i;
  for (int i = ControllerIo::kDigital - 1; i >= digital_outputs_; --i)
    if (outputs.on(i)) missing_ = i;
}

}  // namespace mrroc::edp
