#include "sim/can/injected_drives.hpp"

#include <utility>

namespace mrroc::sim {

namespace {

using faults::Kind;

constexpr std::uint16_t kEncoderFault = 0x7305;  // CiA 402: incremental sensor 1

void set(Kind kind, bool on, std::int64_t now, DriveNode& node) {
  switch (kind) {
    case Kind::fault:
      node.keep_fault(on);
      if (on) node.fail(kEncoderFault);
      return;
    case Kind::silence:
      return node.cut(on);
    case Kind::freeze:
      return node.freeze(on);
    case Kind::hush:
      return node.hush(on);
    case Kind::restart:
      if (on) node.boot(now);
      return;
    case Kind::press:
      return node.press(on);
    case Kind::corrupt:
      return node.corrupt(on);
    default:
      return;
  }
}

/// The wire and the power of a drive are those of all its axes.
bool is_of_node(Kind kind) { return kind == Kind::silence || kind == Kind::hush || kind == Kind::restart; }

void inject(const faults::InjectedFault& fault, bool on, std::int64_t now, std::vector<DriveNode>& nodes) {
  DriveNode& meant = nodes[fault.axis];
  for (DriveNode& node : nodes)
    if (&node == &meant || (is_of_node(fault.kind) && node.node() == meant.node())) set(fault.kind, on, now, node);
}

}  // namespace

InjectedDrives::InjectedDrives(const std::vector<faults::FaultSwitch>& faults, const RobotParameters& robot) {
  faults::check_axes(faults, robot);
  for (const faults::FaultSwitch& each : faults)
    if (each.fault().io == faults::IoPart::none) faults_.push_back({each});
}

void InjectedDrives::apply(Tick tick, std::int64_t now, std::vector<DriveNode>& nodes) {
  for (Injected& each : faults_) {
    const bool on = each.fault.on(tick);
    if (on != std::exchange(each.on, on)) inject(each.fault.fault(), on, now, nodes);
  }
}

}  // namespace mrroc::sim
