#include "drivers/ur/terminals.hpp"

#include <algorithm>

namespace mrroc::ur {

std::vector<std::string> terminal_fields(int tool_terminals) {
  std::vector<std::string> fields{"standard_digital_output_mask",     "standard_digital_output",
                                  "configurable_digital_output_mask", "configurable_digital_output",
                                  "standard_analog_output_mask",      "standard_analog_output_type",
                                  "standard_analog_output_0",         "standard_analog_output_1"};
  if (tool_terminals >= 0) fields.insert(fields.end(), {"tool_digital_output_mask", "tool_digital_output"});
  return fields;
}

void write_terminals(const ControllerIo& outputs, int tool_terminals, std::span<rtde::Value> values) noexcept {
  constexpr std::uint8_t kBoth = 3;
  const auto byte = [](std::uint64_t word, int shift) { return static_cast<std::uint8_t>(word >> shift & 0xffU); };
  const std::uint64_t mask = as_reported(0xffff, tool_terminals), bits = as_reported(outputs.digital, tool_terminals);
  for (std::size_t group = 0; group < 2; ++group) {
    values[2 * group] = byte(mask, static_cast<int>(8 * group));
    values[2 * group + 1] = byte(bits, static_cast<int>(8 * group));
  }
  values[4] = values[5] = kBoth;  // of both terminals; type 1: voltage
  for (std::size_t i = 0; i < 2; ++i) values[6 + i] = std::clamp(outputs.analog[i] / kAnalogRange, 0.0, 1.0);
  if (tool_terminals < 0) return;
  values[8] = byte(mask, 16);
  values[9] = byte(bits, 16);
}

}  // namespace mrroc::ur
