#include "config/network/hosts.hpp"

#include <algorithm>

#include "config/entries/device_name.hpp"
#include "config/entries/named_file.hpp"
#include "config/network/local_host.hpp"
#include "config/text/message_text.hpp"

namespace mrroc::config {

namespace {

/// It becomes a word of ssh's command line and of the DDS configuration.
bool is_address(const std::string& text) {
  const auto allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '-' ||
           c == '_';
  };
  return !text.empty() && text.front() != '-' && std::all_of(text.begin(), text.end(), allowed);
}

std::string absolute_path(const Table& table, const std::string& key) {
  std::string path = table.optional_text(key).value_or("");
  if (!path.empty() && path.front() != '/') table.fail(key, in_quotes(path), "an absolute path on that host");
  return path;
}

HostEntry read_host_entry(const Table& table, const std::string& name) {
  check_name(table, "", name);
  table.only({"address", "command", "mrroc", "folder"});
  HostEntry host;
  host.name = name;
  host.address = table.text("address");
  if (!is_address(host.address))
    table.fail("address", in_quotes(host.address), "a host name or an IPv4 address of letters, digits, '.', '-', '_'");
  if (table.has("command")) {
    host.command = table.texts("command");
    const auto empty = [](const std::string& word) { return word.empty(); };
    if (host.command.empty() || std::any_of(host.command.begin(), host.command.end(), empty))
      table.fail("command", "no words", "a program and its arguments, such as ['ssh', '-p', '2222', 'pc']");
  }
  host.mrroc = absolute_path(table, "mrroc");
  host.folder = absolute_path(table, "folder");
  return host;
}

std::string in_words(const std::string& host) {
  return host.empty() ? "the machine of the runner" : "host " + in_quotes(host);
}

/// The first robot of the simulated world; null if there is no such robot.
const RobotEntry* simulated_robot(const Deployment& deployment) {
  const auto simulated = [](const RobotEntry& robot) { return robot.in_world(); };
  const auto found = std::find_if(deployment.robots.begin(), deployment.robots.end(), simulated);
  return found == deployment.robots.end() ? nullptr : &*found;
}

void settle_simulator(const Table& root, Deployment& deployment) {
  if (!deployment.sim) return;
  if (!root.table("sim").has("host")) {
    const RobotEntry* robot = simulated_robot(deployment);
    deployment.sim->host = robot == nullptr ? "" : robot->host;
  }
  for (const RobotEntry& robot : deployment.robots) {
    if (!robot.in_world() || robot.host == deployment.sim->host) continue;
    const Table table = root.table("robots").table(robot.name);
    table.fail(
        table.has("host") ? "host" : "hardware",
        "a simulated robot on " + in_words(robot.host) + ", but the simulator is on " + in_words(deployment.sim->host),
        "one machine for the simulated world");
  }
}

void settle_sensor(const Table& root, const Deployment& deployment, SensorEntry& sensor) {
  const Table table = root.table("sensors").table(sensor.name);
  const bool simulated = sensor.in_world() && deployment.sim;
  if (!table.has("host"))
    sensor.host = !sensor.robot.empty() ? deployment.robot(sensor.robot).host : simulated ? deployment.sim->host : "";
  if (simulated && sensor.host != deployment.sim->host)
    table.fail(table.has("host") ? "host" : "robot",
               "a simulated sensor on " + in_words(sensor.host) + ", but the simulator is on " +
                   in_words(deployment.sim->host),
               "one machine for the simulated world");
  if (sensor.host == deployment.here) sensor.vsp_program = require_program(table, "type", sensor.vsp_program);
}

}  // namespace

std::vector<HostEntry> read_hosts(const Table& root) {
  std::vector<HostEntry> hosts;
  const auto tables = root.optional_table("hosts");
  if (!tables) return hosts;
  for (const std::string& name : tables->table_names()) hosts.push_back(read_host_entry(tables->table(name), name));
  return hosts;
}

std::string read_host(const Table& table, const Deployment& deployment) {
  std::string host = table.optional_text("host").value_or("");
  std::vector<std::string> known;
  for (const HostEntry& entry : deployment.hosts) {
    if (entry.name == host) return host;
    known.push_back(entry.name);
  }
  // other hosts do not know the names of the runner's machine; the runner has checked them
  if (host.empty() || !deployment.here.empty() || locate_host(host) == HostPlace::local) return "";
  const std::string expected = known.empty() ? "a table [hosts." + host + "]" : alternatives(known);
  table.fail("host", "no host " + in_quotes(host), expected + ", or no key for this machine");
}

void settle_places(const Table& root, Deployment& deployment) {
  settle_simulator(root, deployment);
  if (deployment.sim && deployment.sim->host == deployment.here)
    deployment.sim->program = require_program(root.table("sim"), "", deployment.sim->program);
  for (SensorEntry& sensor : deployment.sensors) settle_sensor(root, deployment, sensor);
  if (!deployment.hosts_used().empty() && deployment.clock != ClockMode::real)
    root.table("deployment")
        .fail(root.table("deployment").has("clock") ? "clock" : "",
              "simulated time is kept in the memory of one machine, and host " +
                  in_quotes(deployment.hosts_used().front()->name) + " is another",
              "clock = 'real'");
  for (const HostEntry& host : deployment.hosts)
    if (host.name == deployment.here) return;
  if (!deployment.here.empty()) root.fail("hosts", "no host " + in_quotes(deployment.here), "the host of this process");
}

}  // namespace mrroc::config
