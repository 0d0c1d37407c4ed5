#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "config/deployment.hpp"
#include "links/telemetry/telemetry_reader.hpp"
#include "links/transport/domain.hpp"
#include "mrroc/robot_state.hpp"
#include "mrroc/sensor_link.hpp"

namespace mrroc::cli {

/// What watchers of a run see of its robots and sensors: at most 50 states of each per second of wall time, newest
/// only. It reads from the processes only while a client watches. Main thread.
class TelemetryFeed {
 public:
  /// Both outlive it.
  TelemetryFeed(const config::Deployment& deployment, links::Domain& domain);

  /// From now on reads the robots, the sensors, or neither.
  void watch(bool robots, bool sensors);
  /// One line of JSON for each robot (event "robot") and sensor (event "reading") that has sent a new state.
  std::vector<std::string> take_robots();
  std::vector<std::string> take_readings();

 private:
  const config::Deployment& deployment_;
  links::Domain& domain_;
  std::map<std::string, std::unique_ptr<links::TelemetryReader<RobotState>>> robots_;
  std::map<std::string, std::unique_ptr<links::TelemetryReader<SensorReading>>> sensors_;
};

/// The event "robot": docs/reference/operator.md. Any thread.
std::string robot_event(const std::string& name, const RobotState& state);
/// The event "reading". Any thread.
std::string reading_event(const config::SensorEntry& sensor, const SensorReading& reading);

}  // namespace mrroc::cli
