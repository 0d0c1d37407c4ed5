#include "drivers/ur/driver_keys.hpp"

#include <cmath>

namespace mrroc::ur {

UrOptions options_of(const config::KeyValues& keys) {
  const auto integer = [&keys](const char* key) { return static_cast<int>(std::lround(keys.number(key))); };
  UrOptions options;
  options.address = keys.text("address");
  options.rtde_port = integer("rtde_port");
  options.dashboard_port = integer("dashboard_port");
  options.script_port = integer("script_port");
  options.frequency = keys.number("frequency");
  options.timeout = keys.number("timeout");
  options.start_timeout = keys.number("start_timeout");
  options.missed_max = integer("missed_max");
  options.registers = integer("registers");
  options.script = keys.text("script");
  options.watchdog = keys.number("watchdog");
  options.servo_gain = keys.number("servo_gain");
  options.servo_lookahead = keys.number("servo_lookahead");
  options.speed_acceleration = keys.number("speed_acceleration");
  options.stop_acceleration = keys.number("stop_acceleration");
  options.tool_voltage = integer("tool_voltage");
  options.tool_terminals = integer("tool_terminals");
  options.speed_slider = keys.number("speed_slider");
  for (std::size_t i = 0; i < options.torque_constants.size(); ++i)
    options.torque_constants[i] = keys.numbers.at("torque_constants").at(i);
  return options;
}

}  // namespace mrroc::ur
