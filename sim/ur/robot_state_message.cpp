#include "sim/ur/robot_state_message.hpp"

#include "sim/ur/message_bytes.hpp"

namespace mrroc::sim::ur {
namespace {

using Contents = std::vector<std::uint8_t>;

constexpr std::uint8_t kVolts = 1;  // range and domain of analogue terminals

/// A package, or a part of one: its length, its kind, its contents.
Contents framed(std::uint8_t kind, const Contents& contents) {
  Contents bytes;
  put(bytes, static_cast<std::int32_t>(contents.size() + 5));
  put(bytes, kind);
  bytes.insert(bytes.end(), contents.begin(), contents.end());
  return bytes;
}

Contents robot_mode(const VirtualController& controller) {
  const auto& version = controller.version();
  const auto is_from = [&version](std::uint32_t minor) {
    return version.major > 3 || (version.major == 3 && version.minor >= minor);
  };
  const bool emergency = (controller.safety_status() & 1u << 7) != 0;
  const bool protective = (controller.safety_status() & 1u << 2) != 0;
  const bool power = (controller.robot_status() & 1u) != 0, runs = (controller.robot_status() & 2u) != 0;
  Contents bytes;
  put(bytes, static_cast<std::uint64_t>(controller.time() * 1e6));
  for (const bool flag : {true, true, power, emergency, protective, runs, false}) put(bytes, flag);
  put(bytes, static_cast<std::uint8_t>(controller.robot_mode()));
  put(bytes, std::uint8_t{0});  // control mode: position
  for (const double value : {controller.speed_slider(), 1.0}) put(bytes, value);
  if (is_from(2)) put(bytes, 1.0);  // limit of the slider
  if (is_from(5)) put(bytes, std::uint8_t{0});
  return bytes;
}

Contents joints(const VirtualController& controller) {
  Contents bytes;
  for (std::size_t i = 0; i < 6; ++i) {
    for (const double value : {controller.position()[i], controller.position()[i], controller.velocity()[i]})
      put(bytes, value);
    for (const float value : {0.0F, 48.0F, 30.0F, 30.0F}) put(bytes, value);
    put(bytes, static_cast<std::uint8_t>(controller.joint_mode(i)));
  }
  return bytes;
}

Contents tool(const VirtualController& controller) {
  Contents bytes;
  put(bytes, std::array{kVolts, kVolts});
  put(bytes, std::array{controller.analog_input(2), controller.analog_input(3)});
  put(bytes, 48.0F);
  put(bytes, static_cast<std::uint8_t>(controller.tool_voltage()));
  put(bytes, std::array{0.0F, 30.0F});  // A, degrees Celsius
  put(bytes, static_cast<std::uint8_t>(JointMode::running));
  return bytes;
}

Contents master_board(const VirtualController& controller) {
  Contents bytes;
  put(bytes, static_cast<std::uint32_t>(controller.digital_inputs()));
  put(bytes, static_cast<std::uint32_t>(controller.digital_outputs()));
  put(bytes, std::array{kVolts, kVolts});
  put(bytes, std::array{controller.analog_input(0), controller.analog_input(1)});
  put(bytes, std::array{kVolts, kVolts});
  put(bytes, std::array{controller.analog_output(0), controller.analog_output(1)});
  put(bytes, std::array{30.0F, 48.0F, 0.0F, 0.0F});  // degrees Celsius, V, A, A
  put(bytes, static_cast<std::uint8_t>(controller.safety_mode()));
  put(bytes, std::array<std::uint8_t, 8>{});  // reduced mode, Euromap 67, reserved, mode selector, enabling device
  return bytes;
}

Contents cartesian(const VirtualController& controller) {
  Contents bytes;
  put(bytes, controller.tool_pose());
  put(bytes, controller.tool_offset());
  return bytes;
}

Contents force_mode(const VirtualController& controller) {
  Contents bytes;
  put(bytes, controller.tool_force());
  put(bytes, 0.0);  // dexterity
  return bytes;
}

}  // namespace

std::vector<std::uint8_t> robot_state_message(const VirtualController& controller) {
  Contents parts;
  const auto add = [&parts](std::uint8_t kind, const Contents& contents) {
    const Contents part = framed(kind, contents);
    parts.insert(parts.end(), part.begin(), part.end());
  };
  add(0, robot_mode(controller));
  add(1, joints(controller));
  add(2, tool(controller));
  add(3, master_board(controller));
  add(4, cartesian(controller));
  add(7, force_mode(controller));
  return framed(16, parts);
}

}  // namespace mrroc::sim::ur
