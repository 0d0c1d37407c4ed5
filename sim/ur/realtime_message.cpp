#include "sim/ur/realtime_message.hpp"

#include "sim/ur/message_bytes.hpp"

namespace mrroc::sim::ur {
namespace {

/// The doubles of a package.
class RealtimeWriter {
 public:
  RealtimeWriter& add(double value) {
    put(bytes_, value);
    return *this;
  }
  RealtimeWriter& add(const Six& values) {
    put(bytes_, values);
    return *this;
  }
  /// Values that the simulated controller does not have.
  RealtimeWriter& zeros(int count) {
    while (count-- > 0) put(bytes_, 0.0);
    return *this;
  }
  std::vector<std::uint8_t> framed() const {
    std::vector<std::uint8_t> package;
    put(package, static_cast<std::int32_t>(bytes_.size() + 4));
    package.insert(package.end(), bytes_.begin(), bytes_.end());
    return package;
  }

 private:
  std::vector<std::uint8_t> bytes_;
};

}  // namespace

std::vector<std::uint8_t> realtime_message(const VirtualController& controller) {
  const auto& version = controller.version();
  const auto is_from = [&version](std::uint32_t major, std::uint32_t minor) {
    return version.major > major || (version.major == major && version.minor >= minor);
  };
  const JointTargets& targets = controller.targets();
  const bool by_position = targets.kind == JointTargets::Kind::position;
  RealtimeWriter writer;
  writer.add(controller.time());
  writer.add(by_position ? targets.position : controller.position()).add(targets.velocity).zeros(18);
  writer.add(controller.position()).add(controller.velocity()).zeros(12);  // currents
  writer.add(controller.tool_pose()).zeros(6).add(controller.tool_force());
  writer.add(controller.tool_pose()).zeros(6);  // targets of the tool
  writer.add(static_cast<double>(controller.digital_inputs())).add(Six{30, 30, 30, 30, 30, 30}).zeros(2);
  writer.add(static_cast<double>(controller.robot_mode()));
  for (std::size_t i = 0; i < 6; ++i) writer.add(static_cast<double>(controller.joint_mode(i)));
  writer.add(static_cast<double>(controller.safety_mode())).zeros(6 + 3 + 6);
  writer.add(1).zeros(1 + 2);  // speed scaling
  writer.add(48).add(48).zeros(1).add(Six{48, 48, 48, 48, 48, 48});
  writer.add(static_cast<double>(controller.digital_outputs()));
  writer.add(static_cast<double>(controller.runtime()));
  if (is_from(3, 5)) writer.zeros(6);  // elbow
  if (is_from(5, 4)) writer.add(static_cast<double>(controller.safety_mode()));
  if (is_from(5, 10)) {
    writer.zeros(3).add(controller.payload());
    for (const double value : controller.payload_centre()) writer.add(value);
    writer.zeros(6);  // inertia
  }
  return writer.framed();
}

}  // namespace mrroc::sim::ur
