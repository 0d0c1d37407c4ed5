#include "config/deployment.hpp"

#include <algorithm>
#include <cmath>

#include "config/clock_names.hpp"
#include "config/entries/answers.hpp"
#include "config/entries/device_name.hpp"
#include "config/entries/driver_entry.hpp"
#include "config/entries/events.hpp"
#include "config/entries/feeder_entry.hpp"
#include "config/entries/force_sensors.hpp"
#include "config/entries/mounts.hpp"
#include "config/entries/named_file.hpp"
#include "config/entries/robot_entry.hpp"
#include "config/entries/sensor_entry.hpp"
#include "config/network/hosts.hpp"
#include "config/network/network_entry.hpp"
#include "config/network/ros2_entry.hpp"
#include "config/resources.hpp"
#include "config/table.hpp"
#include "config/text/calibration_text.hpp"
#include "config/text/file_text.hpp"
#include "config/text/message_text.hpp"

namespace mrroc::config {

namespace {

constexpr std::size_t kMostRobots = 16;
constexpr std::size_t kMostSensors = 32;
constexpr std::size_t kMostProcesses = 60;  // with `mrroc` itself, DDS finds 61 participants on one machine

ClockMode read_clock(const Table& table) {
  if (!table.has("clock")) return ClockMode::lockstep;
  return clock_named(table.choice("clock", clock_names())).value_or(ClockMode::lockstep);
}

void read_general(const Table& table, Deployment& deployment) {
  table.only({"name", "clock", "servo_period", "domain", "start_timeout", "heartbeat_timeout", "link_timeout",
              "clock_error", "delta_limit", "calibration"});
  deployment.name = table.text("name");
  check_name(table, "name", deployment.name);
  deployment.clock = read_clock(table);
  deployment.servo_period = table.number_or("servo_period", deployment.servo_period, {0.0005, 0.02});
  deployment.domain = static_cast<int>(table.integer_or("domain", deployment.domain, 0, 230));
  const Range timeouts{0.1, 3600};
  deployment.start_timeout = table.number_or("start_timeout", deployment.start_timeout, timeouts);
  deployment.heartbeat_timeout = table.number_or("heartbeat_timeout", deployment.heartbeat_timeout, {0.5, 60});
  deployment.link_timeout = table.number_or("link_timeout", deployment.link_timeout, {0.01, 10});
  deployment.clock_error = table.number_or("clock_error", deployment.servo_period / 2, {1e-5, 1});
  const auto deltas = static_cast<std::int64_t>(deployment.delta_limit);
  deployment.delta_limit = static_cast<std::size_t>(table.integer_or("delta_limit", deltas, 2, 1'000'000));
}

/// The MP runs on the runner's machine: its program may be missing on other hosts.
void read_mp(const Table& root, bool here, MpEntry& mp) {
  const auto table = root.optional_table("mp");
  if (!table) {
    if (here) mp.program = require_program(root, "mp", mp.program);
    return;
  }
  table->only({"program", "states"});
  if (table->has("states")) mp.states = require_file(*table, "states");
  if (table->has("states") && table->has("program"))
    table->fail("program", "a state machine is run by the stock MP", "either 'program' or 'states'");
  mp.program = table->optional_text("program").value_or(mp.program);
  if (here) mp.program = require_program(*table, "program", mp.program);
}

SimEntry read_sim(const Table& table, const Deployment& deployment) {
  table.only({"scene", "timestep", "feeders", "host", "errors"});
  const double servo_period = deployment.servo_period;
  SimEntry sim;
  sim.host = read_host(table, deployment);
  sim.scene = require_file(table, "scene");
  sim.timestep = table.number_or("timestep", sim.timestep, {1e-5, 0.02});
  const double steps = servo_period / sim.timestep;
  if (std::round(steps) < 1 || std::abs(steps - std::round(steps)) > 1e-9 * steps) {
    table.fail("timestep", number_text(sim.timestep) + " s does not divide the servo period",
               number_text(servo_period) + " divided by a whole number");
  }
  sim.program = "mrroc_sim";
  sim.feeders = read_feeders(table);
  if (const auto errors = table.optional_table("errors")) sim.errors = read_errors(*errors);
  return sim;
}

/// Reads every sub-table of `root`'s table `kind`, in file order, with `read(table, name)`.
template <typename Read>
void read_devices(const Table& root, const std::string& kind, std::size_t most, Read read) {
  const auto devices = root.optional_table(kind);
  if (!devices) return;
  const auto names = devices->table_names();
  if (names.size() > most) {
    root.fail(kind, std::to_string(names.size()) + " " + kind, "at most " + std::to_string(most));
  }
  for (const auto& name : names) {
    check_device_name(*devices, name);
    read(devices->table(name), name);
  }
}

void refuse_name_of_robot(const Table& sensor, const std::string& name, const Deployment& deployment) {
  for (const auto& robot : deployment.robots) {
    if (robot.name == name) sensor.fail("", in_quotes(name) + " is the name of a robot", "a unique name");
  }
}

/// The EDP of robot `arm` is the process `arm_edp`, its simulated drives are `arm_drives`: no device may have such a
/// name.
void refuse_names_of_robots_processes(const Table& root, const Deployment& deployment) {
  const auto check = [&](const std::string& kind, const std::string& name) {
    for (const auto& robot : deployment.robots) {
      const bool edp = robot.edp_process() == name;
      if (edp || (robot.driver.simulated && robot.drives_process() == name)) {
        root.table(kind).table(name).fail(
            "", in_quotes(name) + (edp ? " is the EDP of robot " : " are the drives of robot ") + in_quotes(robot.name),
            "a unique name");
      }
    }
  };
  for (const auto& robot : deployment.robots) check("robots", robot.name);
  for (const auto& sensor : deployment.sensors) check("sensors", sensor.name);
}

/// The stand-in of sensor `wrist` is the process `wrist_netft`: no device may have that name, and it may not be too
/// long for one.
void check_stand_ins(const Table& root, const Deployment& deployment) {
  for (const SensorEntry& sensor : deployment.sensors) {
    if (!sensor.has_stand_in()) continue;
    const std::string process = sensor.stand_in_process();
    const Table table = root.table("sensors").table(sensor.name);
    const auto same = [&process](const auto& device) { return device.name == process; };
    if (std::any_of(deployment.robots.begin(), deployment.robots.end(), same) ||
        std::any_of(deployment.sensors.begin(), deployment.sensors.end(), same))
      table.fail("source", in_quotes(process) + " is the stand-in of this sensor and the name of a device",
                 "other names");
    if (process.size() > kNameLength)
      table.fail("source", "the name of process " + in_quotes(process) + " is too long",
                 "a sensor's name of at most " + std::to_string(kNameLength - (process.size() - sensor.name.size())) +
                     " characters");
  }
}

/// Once the hosts of all sensors are known.
void find_sensor_drivers(const Table& root, Deployment& deployment) {
  for (SensorEntry& sensor : deployment.sensors)
    if (sensor.driver && sensor.host == deployment.here)
      sensor.driver->library =
          require_library(root.table("sensors").table(sensor.name), "source", "drivers", sensor.driver->name);
}

template <typename Entry>
const Entry& find(const std::vector<Entry>& entries, const std::string& name, const std::string& kind,
                  const Deployment& deployment) {
  std::vector<std::string> known;
  for (const auto& entry : entries) {
    if (entry.name == name) return entry;
    known.push_back(entry.name);
  }
  throw ConfigurationError(deployment.file, 0, kind + "s", "no " + kind + " " + in_quotes(name), alternatives(known));
}

}  // namespace

const RobotEntry& Deployment::robot(const std::string& robot_name) const {
  return find(robots, robot_name, "robot", *this);
}

const SensorEntry& Deployment::sensor(const std::string& sensor_name) const {
  return find(sensors, sensor_name, "sensor", *this);
}

std::vector<const HostEntry*> Deployment::hosts_used() const {
  std::vector<const HostEntry*> used;
  for (const HostEntry& host : hosts) {
    const auto there = [&host](const auto& entry) { return entry.host == host.name; };
    if (std::any_of(robots.begin(), robots.end(), there) || std::any_of(sensors.begin(), sensors.end(), there) ||
        (sim && there(*sim)))
      used.push_back(&host);
  }
  return used;
}

namespace {

/// Of a text that contains the keys of its calibration files.
Deployment read_deployment(const std::filesystem::path& file, const std::string& text) {
  const Table root = Table::parse(file, text);
  root.only({"deployment", "hosts", "mp", "robots", "sensors", "sim", "network", "ros2", "events", "answers"});
  Deployment deployment;
  deployment.file = std::filesystem::absolute(file);
  deployment.here = this_host();
  read_general(root.table("deployment"), deployment);
  deployment.hosts = read_hosts(root);
  read_mp(root, deployment.here.empty(), deployment.mp);
  if (const auto sim = root.optional_table("sim")) deployment.sim = read_sim(*sim, deployment);
  read_devices(root, "robots", kMostRobots, [&deployment](const Table& table, const std::string& name) {
    deployment.robots.push_back(read_robot(table, name, deployment));
  });
  check_mounts(root, deployment);
  read_devices(root, "sensors", kMostSensors, [&deployment](const Table& table, const std::string& name) {
    refuse_name_of_robot(table, name, deployment);
    deployment.sensors.push_back(read_sensor(table, name, deployment));
  });
  settle_places(root, deployment);
  find_sensor_drivers(root, deployment);
  check_stand_ins(root, deployment);
  settle_force_sensors(root, deployment);
  refuse_names_of_robots_processes(root, deployment);
  const auto simulated_drives =
      static_cast<std::size_t>(std::count_if(deployment.robots.begin(), deployment.robots.end(),
                                             [](const RobotEntry& robot) { return robot.driver.simulated; }));
  const auto simulated_sensors =
      static_cast<std::size_t>(std::count_if(deployment.sensors.begin(), deployment.sensors.end(),
                                             [](const SensorEntry& sensor) { return sensor.has_stand_in(); }));
  const std::size_t processes = 2 * deployment.robots.size() + simulated_drives + simulated_sensors +
                                deployment.sensors.size() + 1 + (deployment.sim ? 1 : 0);
  if (processes > kMostProcesses) {
    root.fail("",
              std::to_string(processes) + " processes (two per robot, " +
                  (simulated_drives > 0 ? "one more with simulated drives, " : "") + "one per sensor, the MP" +
                  (deployment.sim ? ", the simulator)" : ")"),
              "at most " + std::to_string(kMostProcesses));
  }
  deployment.network = read_network(root, deployment);
  deployment.ros2 = read_ros2(root);
  deployment.events = read_events(root, deployment);
  deployment.answers = read_answers(root, deployment);
  if (deployment.robots.empty() && deployment.sensors.empty()) {
    root.fail("", "no robots and no sensors", "at least one [robots.NAME] or [sensors.NAME]");
  }
  return deployment;
}

}  // namespace

Deployment load_deployment(const std::filesystem::path& file) { return load_deployment(file, read_file(file)); }

Deployment load_deployment(const std::filesystem::path& file, const std::string& text) {
  const std::string calibrated = with_calibrations(file, text);
  Deployment deployment = read_deployment(file, text);  // reports mistakes of the deployment at their own lines
  if (calibrated == text) return deployment;
  try {
    deployment = read_deployment(file, calibrated);
    deployment.calibrations = calibration_files(file, text);
    return deployment;
  } catch (const ConfigurationError& error) {
    if (const auto at = calibration_line(file, text, error.key()))
      throw ConfigurationError(at->file, at->line, error.key(), error.problem(), error.expected());
    throw ConfigurationError(file, 0, "deployment.calibration",
                             "its files make the deployment invalid: " + std::string(error.what()),
                             "the keys that `mrroc calibrate` writes");
  }
}

}  // namespace mrroc::config
