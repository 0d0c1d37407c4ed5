#include "drivers/ur/command.hpp"

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

std::vector<std::string> slider_fields() { return {"speed_slider_mask", "speed_slider_fraction"}; }

void write_slider(double fraction, std::span<rtde::Value> values) noexcept {
  values[0] = std::uint32_t{1};
  values[1] = fraction;
}

}  // namespace mrroc::ur
