#include "cli/can/io_frame_text.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

namespace mrroc::cli {

namespace {

using namespace canopen;

constexpr std::uint32_t kBetweenPdos = 0x100;  // of the identifiers of two PDOs of a node
constexpr int kAnalogInPdo = 4;

/// "0 to 7, on: 0, 3".
std::string digital_text(const config::TerminalRange& range, const ControllerIo& io) {
  std::string on;
  for (int i = range.first; i < range.first + range.count; ++i)
    if (io.on(i)) on += (on.empty() ? "" : ", ") + std::to_string(i);
  const int last = range.first + range.count - 1;
  const std::string all =
      range.count == 1 ? std::to_string(last) : std::to_string(range.first) + " to " + std::to_string(last);
  return all + (on.empty() ? ", all off" : ", on: " + on);
}

/// "0 = 4.321, 1 = -2.000": the values of PDO `number`.
std::string analog_text(const config::TerminalRange& range, int number, const ControllerIo& io) {
  const int first = (number - 2) * kAnalogInPdo;
  std::string text;
  for (int i = first; i < std::min(first + kAnalogInPdo, range.count); ++i) {
    const int terminal = range.first + i;
    text +=
        fmt::format("{}{} = {:.3f}", text.empty() ? "" : ", ", terminal, io.analog[static_cast<std::size_t>(terminal)]);
  }
  return text;
}

}  // namespace

IoFrameText::IoFrameText(const config::IoEntry& entry) : entry_(entry), pdos_(entry) {}

std::optional<std::string> IoFrameText::process_data(const can::Frame& frame) const {
  for (int number = 1; number <= edp::IoPdos::kCount; ++number) {
    const std::uint32_t own = kBetweenPdos * static_cast<std::uint32_t>(number - 1) + entry_.node;
    ControllerIo io;
    if (frame.id == kTransmitPdo1 + own && pdos_.transmit(number).size() != 0 && pdos_.read(frame, number, io))
      return fmt::format("TPDO {}: {}", number,
                         number == 1 ? "digital inputs " + digital_text(entry_.digital_inputs, io)
                                     : "analogue inputs " + analog_text(entry_.analog_inputs, number, io));
    if (frame.id == kReceivePdo1 + own && pdos_.receive(number).size() != 0 && pdos_.read_outputs(frame, number, io))
      return fmt::format("RPDO {}: {}", number,
                         number == 1 ? "digital outputs " + digital_text(entry_.digital_outputs, io)
                                     : "analogue outputs " + analog_text(entry_.analog_outputs, number, io));
  }
  return {};
}

}  // namespace mrroc::cli
