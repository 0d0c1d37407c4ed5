#include "drivers/ur/options.hpp"

#include <cmath>
#include <stdexcept>

namespace mrroc::ur {
namespace {

void check_range(const char* name, double value, double least, double greatest) {
  if (value >= least && value <= greatest) return;
  throw std::invalid_argument(std::string(name) + " is " + std::to_string(value) + ", expected " +
                              std::to_string(least) + " to " + std::to_string(greatest));
}

}  // namespace

void check(const UrOptions& options) {
  if (options.address.empty()) throw std::invalid_argument("address is missing, expected the controller's host or IP");
  for (const auto& [name, port] :
       {std::pair{"rtde_port", options.rtde_port}, std::pair{"dashboard_port", options.dashboard_port},
        std::pair{"script_port", options.script_port}})
    check_range(name, port, 1, 65535);
  check_range("frequency", options.frequency, 0, 500);
  check_range("timeout", options.timeout, 0.01, 60);
  check_range("start_timeout", options.start_timeout, 0.01, 600);
  check_range("open_timeout", options.open_timeout, 0, 600);
  check_range("missed_max", options.missed_max, 1, 500);
  check_range("registers", options.registers, 0, 36);
  check_range("watchdog", options.watchdog, 0.004, 10);
  check_range("servo_gain", options.servo_gain, 100, 2000);
  check_range("servo_lookahead", options.servo_lookahead, 0.03, 0.2);
  check_range("speed_acceleration", options.speed_acceleration, 0.01, 1000);
  check_range("stop_acceleration", options.stop_acceleration, 0.01, 1000);
  check_range("payload_mass", options.payload_mass, 0, 100);
  for (const double length : options.payload_centre) check_range("payload_centre", length, -10, 10);
  if (options.tool_voltage != -1 && options.tool_voltage != 0 && options.tool_voltage != 12 &&
      options.tool_voltage != 24)
    throw std::invalid_argument("tool_voltage is " + std::to_string(options.tool_voltage) +
                                ", expected 0, 12 or 24, or -1 to leave it unchanged");
  check_range("tool_terminals", options.tool_terminals, -1, 14);
  if (options.speed_slider != 0) check_range("speed_slider", options.speed_slider, 0.01, 1);
  for (const double constant : options.torque_constants) check_range("torque_constants", constant, 0, 1000);
}

}  // namespace mrroc::ur
