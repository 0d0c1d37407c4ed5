#include "drivers/ur/command.hpp"

#include <algorithm>

namespace mrroc::ur {

std::vector<std::string> set_point_fields(int registers) {
  std::vector<std::string> fields;
  fields.reserve(14);
  for (int i = 0; i < 2; ++i) fields.push_back("input_int_register_" + std::to_string(registers + i));
  for (int i = 0; i < 12; ++i) fields.push_back("input_double_register_" + std::to_string(registers + i));
  return fields;
}

void write_set_points(const Command& command, std::span<rtde::Value> values) noexcept {
  values[0] = command.sequence;
  values[1] = static_cast<std::int32_t>(command.mode);
  for (std::size_t i = 0; i < 6; ++i) {
    values[2 + i] = command.position[i];
    values[8 + i] = command.velocity[i];
  }
}

std::vector<std::string> terminal_fields() {
  return {"standard_digital_output_mask", "standard_digital_output",     "configurable_digital_output_mask",
          "configurable_digital_output",  "standard_analog_output_mask", "standard_analog_output_type",
          "standard_analog_output_0",     "standard_analog_output_1"};
}

void write_terminals(const ControllerIo& outputs, std::span<rtde::Value> values) noexcept {
  constexpr std::uint8_t kAll = 0xff, kBoth = 3;
  values[0] = values[2] = kAll;
  values[1] = static_cast<std::uint8_t>(outputs.digital & 0xff);
  values[3] = static_cast<std::uint8_t>(outputs.digital >> 8);
  values[4] = values[5] = kBoth;  // of both terminals; type 1: voltage
  for (std::size_t i = 0; i < 2; ++i) values[6 + i] = std::clamp(outputs.analog[i] / kAnalogRange, 0.0, 1.0);
}

std::vector<std::string> slider_fields() { return {"speed_slider_mask", "speed_slider_fraction"}; }

void write_slider(double fraction, std::span<rtde::Value> values) noexcept {
  values[0] = std::uint32_t{1};
  values[1] = fraction;
}

}  // namespace mrroc::ur
