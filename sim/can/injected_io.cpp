#include "sim/can/injected_io.hpp"

#include <string>

#include "mrroc/errors.hpp"

namespace mrroc::sim {

namespace {

using faults::InjectedFault;
using faults::IoPart;
using faults::Kind;

constexpr std::uint16_t kDeviceError = 0x5000;  // EMCY of CiA 301: device hardware

void set(Kind kind, bool on, std::int64_t now, IoNode& node) {
  switch (kind) {
    case Kind::fault:
      return node.fail(on ? kDeviceError : 0);
    case Kind::silence:
      return node.cut(on);
    case Kind::hush:
      return node.hush(on);
    case Kind::restart:
      if (on) node.boot(now);
      return;
    default:
      return;
  }
}

[[noreturn]] void refuse(const InjectedFault& fault, const std::string& why) {
  throw NonFatalError(ErrorCode::invalid_argument, "the fault \"" + fault.text + "\": " + why);
}

std::size_t place_of_node(const InjectedFault& fault, const config::IoTable& io) {
  std::string known;
  for (std::size_t i = 0; i < io.nodes.size(); ++i) {
    if (io.nodes[i].node == fault.io_number) return i;
    known += (known.empty() ? "" : ", ") + std::to_string(io.nodes[i].node);
  }
  refuse(fault, "the robot has no I/O node " + std::to_string(fault.io_number) +
                    (known.empty() ? ", it has no I/O nodes" : ", expected one of " + known));
}

void check_input(const InjectedFault& fault, const config::IoTable& io) {
  const bool digital = fault.io == IoPart::digital_input;
  int count = 0;
  for (const config::IoEntry& node : io.nodes) count += digital ? node.digital_inputs.count : node.analog_inputs.count;
  if (fault.io_number < count) return;
  refuse(fault, "the robot's I/O nodes have no " + std::string{digital ? "digital" : "analogue"} + " input " +
                    std::to_string(fault.io_number) +
                    (count == 0 ? ", they have none" : ", expected 0 to " + std::to_string(count - 1)));
}

}  // namespace

InjectedIo::InjectedIo(const std::vector<faults::FaultSwitch>& faults, const config::IoTable& io) {
  for (const faults::FaultSwitch& each : faults) {
    const InjectedFault& fault = each.fault();
    if (fault.io == IoPart::none) continue;
    if (fault.io != IoPart::node) check_input(fault, io);
    faults_.push_back({each, fault.io == IoPart::node ? place_of_node(fault, io) : 0});
  }
}

void InjectedIo::apply(Tick tick, std::int64_t now, std::vector<IoNode>& nodes, ControllerIo& inputs) {
  for (Injected& each : faults_) {
    const InjectedFault& fault = each.fault.fault();
    const bool on = each.fault.on(tick);
    if (fault.io == IoPart::node && on != each.on) set(fault.kind, on, now, nodes[each.node]);
    if (fault.io == IoPart::digital_input && on) inputs.set(fault.io_number, fault.value != 0);
    if (fault.io == IoPart::analog_input && on) inputs.analog[static_cast<std::size_t>(fault.io_number)] = fault.value;
    each.on = on;
  }
}

}  // namespace mrroc::sim
