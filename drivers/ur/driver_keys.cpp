#include "drivers/ur/driver_keys.hpp"

#include <cmath>

namespace mrroc::ur {

UrOptions options_of(const std::map<std::string, std::vector<double>>& numbers,
                     const std::map<std::string, std::string>& texts) {
  const auto number = [&numbers](const char* key) { return numbers.at(key).at(0); };
  const auto integer = [&number](const char* key) { return static_cast<int>(std::lround(number(key))); };
  UrOptions options;
  options.address = texts.at("address");
  options.rtde_port = integer("rtde_port");
  options.dashboard_port = integer("dashboard_port");
  options.script_port = integer("script_port");
  options.frequency = number("frequency");
  options.timeout = number("timeout");
  options.start_timeout = number("start_timeout");
  options.missed_max = integer("missed_max");
  options.registers = integer("registers");
  options.script = texts.at("script");
  options.watchdog = number("watchdog");
  options.servo_gain = number("servo_gain");
  options.servo_lookahead = number("servo_lookahead");
  options.speed_acceleration = number("speed_acceleration");
  options.stop_acceleration = number("stop_acceleration");
  options.tool_voltage = integer("tool_voltage");
  options.speed_slider = number("speed_slider");
  for (std::size_t i = 0; i < options.torque_constants.size(); ++i)
    options.torque_constants[i] = numbers.at("torque_constants").at(i);
  return options;
}

}  // namespace mrroc::ur
