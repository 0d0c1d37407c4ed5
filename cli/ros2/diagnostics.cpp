#include "cli/ros2/diagnostics.hpp"

#include <nlohmann/json.hpp>

namespace mrroc::cli {

namespace {

using Json = nlohmann::ordered_json;
using messages::diagnostic_msgs::DiagnosticStatus;

std::string text_of(const Json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); }

void add(DiagnosticStatus& status, const Json& event, const char* key) {
  if (const auto found = event.find(key); found != event.end())
    status.values.push_back({.key = key, .value = text_of(*found)});
}

/// The text of an event's error; empty without one.
std::string error_of(const Json& event) {
  const auto error = event.find("error");
  if (error == event.end()) return {};
  if (!error->is_object()) return text_of(*error);
  const std::string detail = error->value("detail", "");
  return error->value("text", "") + (detail.empty() ? "" : ": " + detail);
}

DiagnosticStatus process_status(const Json& event) {
  DiagnosticStatus status;
  status.message = event.value("state", "");
  for (const char* key : {"role", "tick", "activity", "step", "missed_ticks", "late_commands"}) add(status, event, key);
  return status;
}

DiagnosticStatus robot_status(const Json& event) {
  DiagnosticStatus status;
  const bool enabled = event.value("enabled", false);
  const bool synchronised = event.value("synchronised", false);
  if (!enabled || !synchronised) status.level = DiagnosticStatus::WARN;
  status.message = !enabled ? "drives are off" : synchronised ? "ready" : "not synchronised";
  for (const char* key : {"tick", "enabled", "synchronised", "late_commands", "inputs", "outputs"})
    add(status, event, key);
  return status;
}

}  // namespace

void Diagnostics::take(const Json& event) {
  const bool robot = event.value("event", "") == "robot";
  DiagnosticStatus status = robot ? robot_status(event) : process_status(event);
  if (const std::string error = error_of(event); !error.empty()) {
    status.level = DiagnosticStatus::ERROR;
    status.message = error;
  }
  const std::string name = event.value("name", "");
  status.name = deployment_ + ": " + (robot ? "robot " : "process ") + name;
  status.hardware_id = name;
  states_[status.name] = std::move(status);
}

messages::diagnostic_msgs::DiagnosticArray Diagnostics::message(const messages::builtin_interfaces::Time& stamp) const {
  messages::diagnostic_msgs::DiagnosticArray array;
  array.header.stamp = stamp;
  for (const auto& [name, status] : states_) array.status.push_back(status);
  return array;
}

}  // namespace mrroc::cli
