#include "config/entries/sensor_entry.hpp"

#include <algorithm>
#include <cmath>

#include "config/entries/driver_entry.hpp"
#include "config/entries/named_file.hpp"
#include "config/entries/sensor_type.hpp"
#include "config/network/hosts.hpp"
#include "config/resources.hpp"
#include "config/text/message_text.hpp"

namespace mrroc::config {

namespace {

/// 166.667 Hz means every third servo period of 2 ms.
constexpr double kRateTolerance = 1e-4;
constexpr double kMostPeriods = 1e9;  // weeks: a mistaken rate, and beyond the range of a tick

std::string read_robot_of(const Table& table, const Deployment& deployment) {
  if (!table.has("robot")) return "";
  std::string name = table.text("robot");
  std::vector<std::string> known;
  for (const auto& robot : deployment.robots) {
    if (robot.name == name) return name;
    known.push_back(robot.name);
  }
  table.fail("robot", "no robot " + in_quotes(name), alternatives(known));
}

/// The exact rate of one reading in a whole number of servo periods.
double read_rate(const Table& table, double servo_period) {
  const double rate = table.number("rate");
  const double periods = 1 / (rate * servo_period);
  const double whole = std::round(periods);
  if (!(rate > 0) || whole < 1 || whole > kMostPeriods || std::abs(periods - whole) > kRateTolerance * periods) {
    table.fail("rate", number_text(rate) + " Hz is not one reading in a whole number of servo periods",
               number_text(1 / servo_period) + " divided by a whole number");
  }
  return 1 / (whole * servo_period);
}

void read_mode(const Table& table, double servo_period, SensorEntry& sensor) {
  const std::string mode =
      table.has("mode") ? table.choice("mode", {"interactive", "polled", "non-interactive"}) : "interactive";
  sensor.interactive = mode != "non-interactive";
  sensor.polled = mode == "polled";
  if (!sensor.interactive) {
    sensor.rate = read_rate(table, servo_period);
  } else if (table.has("rate")) {
    table.fail("rate", "an interactive sensor has no rate", "mode = 'non-interactive' beside it");
  }
}

/// A sensor inside the controller of its robot is simulated where the robot is.
void join_controller(const Table& table, const Deployment& deployment, SensorEntry& sensor) {
  DriverEntry& driver = *sensor.driver;
  if (driver.controller.empty()) return;
  std::vector<std::string> suitable;
  for (const RobotEntry& robot : deployment.robots) {
    if (robot.driver.name != driver.controller) continue;
    suitable.push_back(robot.name);
    if (robot.name != sensor.robot) continue;
    driver.simulated = robot.driver.simulated;
    return;
  }
  table.fail(table.has("robot") ? "robot" : "source",
             "source " + in_quotes(driver.controller) + " is the controller of a robot",
             suitable.empty() ? "a robot with hardware = " + in_quotes(driver.controller)
                              : "robot = " + alternatives(suitable));
}

void read_source(const Table& table, const Deployment& deployment, SensorEntry& sensor) {
  const std::vector<std::string> drivers = sensor_drivers(sensor.type);
  if (table.has("source")) {
    std::vector<std::string> choices = sensor.sources;
    choices.insert(choices.end(), drivers.begin(), drivers.end());
    sensor.source = table.choice("source", choices);
  }
  if (std::find(drivers.begin(), drivers.end(), sensor.source) != drivers.end())
    sensor.driver = read_driver(table, "source", sensor.name, sensor.type, sensor.host, deployment);
  if (sensor.driver)
    join_controller(table, deployment, sensor);
  else
    refuse_driver_tables(table, "source", sensor.source, "sensor");
  if (sensor.source == "replay") {
    sensor.replay = require_file(table, "replay");
    return;
  }
  if (table.has("replay")) {
    table.fail("replay", "a sensor with source " + in_quotes(sensor.source) + " plays no file",
               "source = 'replay' beside it");
  }
  if (sensor.source == "simulated" && !deployment.sim)
    table.fail("source", "a simulated sensor needs a simulator", "a table [sim]");
}

}  // namespace

SensorEntry read_sensor(const Table& table, const std::string& name, const Deployment& deployment) {
  SensorEntry sensor;
  sensor.name = name;
  sensor.type = table.choice("type", sensor_types());
  read_sensor_type(table, sensor);
  allow_driver_tables(table, "sensor", sensor_drivers(sensor.type));
  table.only({"type", "robot", "mode", "rate", "source", "replay", "frozen_after", "noise_max", "host"});
  sensor.host = read_host(table, deployment);
  sensor.robot = read_robot_of(table, deployment);
  read_mode(table, deployment.servo_period, sensor);
  read_source(table, deployment, sensor);
  sensor.frozen_after = table.number_or("frozen_after", 0, {.min = 0});
  if (const auto noise = table.optional_numbers("noise_max", 0, {.min = 0})) sensor.noise_max = *noise;
  sensor.vsp_program = sensor.type + "_vsp";
  return sensor;
}

}  // namespace mrroc::config
