#include "sim/ur/robot_state_message.hpp"

#include <array>

#include "drivers/ur/rtde/wire.hpp"

namespace mrroc::sim::ur {
namespace {

using mrroc::ur::rtde::WireWriter;

template <class T>
void put(std::vector<std::uint8_t>& bytes, T value) {
  std::array<std::uint8_t, sizeof(T)> memory{};
  WireWriter writer(memory);
  writer.put(value);
  bytes.insert(bytes.end(), memory.begin(), memory.end());
}

/// A package of the primary or secondary interface, or a part of one: its length, its kind, its contents.
std::vector<std::uint8_t> framed(std::uint8_t kind, const std::vector<std::uint8_t>& contents) {
  std::vector<std::uint8_t> bytes;
  put(bytes, static_cast<std::int32_t>(contents.size() + 5));
  put(bytes, kind);
  bytes.insert(bytes.end(), contents.begin(), contents.end());
  return bytes;
}

}  // namespace

std::vector<std::uint8_t> robot_state_message(const VirtualController& controller) {
  const bool emergency = (controller.safety_status() & 1u << 7) != 0;
  const bool protective = (controller.safety_status() & 1u << 2) != 0;
  std::vector<std::uint8_t> mode;
  put(mode, static_cast<std::uint64_t>(controller.time() * 1e6));
  const bool power = (controller.robot_status() & 1u) != 0, runs = (controller.robot_status() & 2u) != 0;
  for (const bool flag : {true, true, power, emergency, protective, runs, false})
    put(mode, static_cast<std::uint8_t>(flag));
  put(mode, static_cast<std::uint8_t>(controller.robot_mode()));
  put(mode, std::uint8_t{0});
  for (const double value : {controller.speed_slider(), 1.0, 1.0}) put(mode, value);
  put(mode, std::uint8_t{0});
  std::vector<std::uint8_t> joints;
  for (std::size_t i = 0; i < 6; ++i) {
    for (const double value : {controller.position()[i], controller.position()[i], controller.velocity()[i]})
      put(joints, value);
    for (const float value : {0.0F, 48.0F, 30.0F, 30.0F}) put(joints, value);
    put(joints, static_cast<std::uint8_t>(controller.joint_mode(i)));
  }
  std::vector<std::uint8_t> parts = framed(0, mode);
  const std::vector<std::uint8_t> second = framed(1, joints);
  parts.insert(parts.end(), second.begin(), second.end());
  return framed(16, parts);
}

}  // namespace mrroc::sim::ur
