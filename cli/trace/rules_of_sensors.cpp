// v^i: when a reading is renewed, and its tick.
#include <algorithm>
#include <bit>

#include "cli/trace/rule.hpp"
#include "cli/trace/words.hpp"

namespace mrroc::cli::trace {

namespace {

/// Ticks of a step without robots.
constexpr Tick kStepWithoutRobots = 10;

bool due(const Line& line, const SensorEntry& sensor) { return line.held != 0 || line.step % sensor.period == 0; }

bool same_values(const Numbers& a, const Numbers& b) {
  const auto same = [](double x, double y) {
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

void sensor_period(const Step& step, Findings& findings) {
  if (step.before == nullptr || step.line.broken_off()) return;
  for (std::size_t i = 0; i < std::min(step.line.sensors.size(), step.before->sensors.size()); ++i) {
    const SensorEntry& now = step.line.sensors[i];
    const SensorEntry& before = step.before->sensors[i];
    if (due(step.line, now) || (now.tick == before.tick && same_values(now.values, before.values))) continue;
    findings.add(words("a new reading of ", now.name, " at step ", step.line.step),
                 words("that of tick ", before.tick, ": it has one every ", now.period, " steps"));
  }
}

/// The tick for which an interactive reading was requested.
void sensor_tick(const Step& step, Findings& findings) {
  const Line& line = step.line;
  if (!step.simulated() || line.broken_off()) return;
  Tick asked = 0;
  for (const RobotEntry& robot : line.robots) {
    if (robot.error != ErrorClass::none) return;
    asked = std::max(asked, robot.tick);
  }
  if (line.robots.empty()) {
    if (step.before == nullptr) return;
    asked = step.before->tick + kStepWithoutRobots * (1 + line.held);
  }
  for (const SensorEntry& sensor : line.sensors) {
    if (sensor.mode != SensorMode::interactive || sensor.error != ErrorClass::none || !due(line, sensor)) continue;
    if (sensor.tick < asked)
      findings.add(words("tick=", sensor.tick, " of sensor ", sensor.name), words("at least ", asked, ", this step's"));
  }
}

void sensor_values(const Step& step, Findings& findings) {
  if (step.process == nullptr) return;
  for (const SensorEntry& sensor : step.line.sensors) {
    const auto known = step.process->sensors.find(sensor.name);
    if (known == step.process->sensors.end() || known->second.values.empty()) continue;
    if (sensor.emptied_since(known->second)) continue;
    if (sensor.values.size() != known->second.values.size())
      findings.add(words(sensor.values.size(), " values of sensor ", sensor.name), words(known->second.values.size()));
  }
}

void sensor_configuration(const Step& step, Findings& findings) {
  for (const SensorEntry& sensor : step.line.sensors) {
    if (sensor.configuration < sensor.configured)
      findings.add(words("configuration=", sensor.configuration, " of sensor ", sensor.name),
                   words("at least ", sensor.configured, ", that the process has set"));
    if (step.process == nullptr) continue;
    const auto known = step.process->sensors.find(sensor.name);
    if (known != step.process->sensors.end() && sensor.configuration < known->second.configuration)
      findings.add(words("configuration=", sensor.configuration, " of sensor ", sensor.name),
                   words("at least ", known->second.configuration, ", that of the reading before"));
  }
}

}  // namespace

Rules rules_of_sensors() {
  return {{"sensor-period", "(3) (5): v(i)", "a reading is renewed every `period` steps only", sensor_period},
          {"sensor-tick", "(3) (5): v(i)", "an interactive reading that is due is not older than the robots' states",
           sensor_tick},
          {"sensor-values", "(2): v", "a sensor has the same number of values at every reading", sensor_values},
          {"sensor-configuration", "(14): c_l", "a reading made with an older configuration is not taken for a new one",
           sensor_configuration}};
}

}  // namespace mrroc::cli::trace
