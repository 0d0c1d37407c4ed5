#include "cli/operator/watching/telemetry_feed.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "mrroc/errors.hpp"

namespace mrroc::cli {

namespace {

using Json = nlohmann::ordered_json;

template <class Vector>
Json numbers(const Vector& values) {
  Json array = Json::array();
  for (Eigen::Index i = 0; i < values.size(); ++i) array.push_back(values[i]);
  return array;
}

/// Position (m) and the quaternion x, y, z, w.
Json numbers(const Pose& pose) {
  const Eigen::Quaterniond rotation(pose.linear());
  const Eigen::Vector3d position = pose.translation();
  return Json::array(
      {position.x(), position.y(), position.z(), rotation.x(), rotation.y(), rotation.z(), rotation.w()});
}

void add_error(const ErrorReport& error, Json& json) {
  if (error.code == ErrorCode::none) return;
  json["error"] = Json{{"code", static_cast<int>(error.code)},
                       {"text", std::string{describe(error.code)}},
                       {"detail", std::string{error.detail.view()}}};
}

std::string line_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

std::string topic_of(const config::Deployment& deployment, const std::string& name) {
  return deployment.name + "/" + name + "/telemetry";
}

}  // namespace

TelemetryFeed::TelemetryFeed(const config::Deployment& deployment, links::Domain& domain)
    : deployment_(deployment), domain_(domain) {}

void TelemetryFeed::watch(bool robots, bool sensors) {
  if (!robots) robots_.clear();
  if (!sensors) sensors_.clear();
  if (robots && robots_.empty())
    for (const config::RobotEntry& robot : deployment_.robots)
      robots_[robot.name] =
          std::make_unique<links::TelemetryReader<RobotState>>(domain_, topic_of(deployment_, robot.name));
  if (sensors && sensors_.empty())
    for (const config::SensorEntry& sensor : deployment_.sensors)
      sensors_[sensor.name] =
          std::make_unique<links::TelemetryReader<SensorReading>>(domain_, topic_of(deployment_, sensor.name));
}

std::vector<std::string> TelemetryFeed::take_robots() {
  std::vector<std::string> lines;
  RobotState state;
  for (const auto& [name, reader] : robots_)
    if (reader->take(state)) lines.push_back(robot_event(name, state));
  return lines;
}

std::vector<std::string> TelemetryFeed::take_readings() {
  std::vector<std::string> lines;
  SensorReading reading;
  for (const auto& [name, reader] : sensors_)
    if (reader->take(reading)) lines.push_back(reading_event(deployment_.sensor(name), reading));
  return lines;
}

std::string robot_event(const std::string& name, const RobotState& state) {
  Json json{{"event", "robot"},
            {"name", name},
            {"tick", state.tick},
            {"joints", numbers(state.joints)},
            {"velocity", numbers(state.joint_velocity)},
            {"desired", numbers(state.desired_joints)},
            {"motors", numbers(state.motors)},
            {"current", numbers(state.current)},
            {"pose", numbers(state.pose)},
            {"tool", numbers(state.tool)},
            {"desired_pose", numbers(state.desired_pose)},
            {"wrench", numbers(state.wrench)},
            {"inputs", state.inputs.digital},
            {"outputs", state.outputs.digital},
            {"synchronised", state.synchronised},
            {"enabled", state.enabled},
            {"late_commands", state.late_commands}};
  add_error(state.error, json);
  return line_of(json);
}

std::string reading_event(const config::SensorEntry& sensor, const SensorReading& reading) {
  Json json{{"event", "reading"}, {"name", sensor.name}, {"tick", reading.tick}, {"values", Json::object()}};
  const std::size_t count = std::min<std::size_t>(reading.channel_count, sensor.channels.size());
  for (std::size_t i = 0; i < count; ++i) json["values"][sensor.channels[i].name] = reading.values[i];
  add_error(reading.error, json);
  return line_of(json);
}

}  // namespace mrroc::cli
