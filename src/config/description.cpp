#include "config/description.hpp"

#include <algorithm>
#include <utility>

#include "config/clock_names.hpp"
#include "config/text/message_text.hpp"

namespace mrroc::config {

namespace {

using Lines = std::vector<std::pair<std::string, std::string>>;  // process or device, description

std::string on_host(const std::string& host) { return host.empty() ? "" : "host " + host + ", "; }

/// " can0 with the drives of <file> and the I/O nodes of <file>".
std::string on_bus(const RobotEntry& robot) {
  if (!robot.can) return "";
  std::string text = " " + robot.can->interface + " with the drives of " + robot.can->drives.string();
  if (!robot.can->io.empty()) text += " and the I/O nodes of " + robot.can->io.string();
  return text;
}

std::string describe(const RobotEntry& robot) {
  const std::string mount = robot.mount.empty() ? "" : " carried by " + robot.mount;
  return on_host(robot.host) + robot.type + mount + " on " + robot.driver.name + on_bus(robot) + ": ECP " +
         robot.program + ", EDP " + robot.edp_program +
         (robot.driver.simulated ? ", simulated drives " + robot.driver.stand_in : "");
}

std::string describe(const SensorEntry& sensor) {
  std::string text = on_host(sensor.host) + sensor.type;
  if (!sensor.robot.empty()) text += " on " + sensor.robot;
  text += sensor.interactive ? (sensor.polled ? ", polled, " : ", interactive, ")
                             : ", non-interactive at " + number_text(sensor.rate) + " Hz, ";
  text += sensor.source;
  if (!sensor.replay.empty()) text += " of " + sensor.replay.string();
  text += ": VSP " + sensor.vsp_program;
  return sensor.has_stand_in() ? text + ", stand-in " + sensor.driver->stand_in : text;
}

}  // namespace

std::string describe(const Deployment& deployment) {
  std::string text = deployment.name + ": " + name_of(deployment.clock) + ", servo period " +
                     number_text(deployment.servo_period) + " s, ";
  text += deployment.domain < 0 ? "any free DDS domain" : "DDS domain " + std::to_string(deployment.domain);
  text += "\n";

  Lines lines{{"mp", deployment.mp.program}};
  if (const auto& sim = deployment.sim) {
    lines.emplace_back("sim", on_host(sim->host) + sim->program + ", scene " + sim->scene.string() + ", time step " +
                                  number_text(sim->timestep) + " s");
  }
  for (const auto& robot : deployment.robots) lines.emplace_back(robot.name, describe(robot));
  for (const auto& sensor : deployment.sensors) lines.emplace_back(sensor.name, describe(sensor));

  std::size_t width = 0;
  for (const auto& line : lines) width = std::max(width, line.first.size());
  for (auto& [name, description] : lines) {
    name.resize(width + 2, ' ');
    text.append("  ").append(name).append(description).append("\n");
  }
  return text;
}

}  // namespace mrroc::config
