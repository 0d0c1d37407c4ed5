#include "config/entries/events.hpp"

#include <algorithm>
#include <limits>

#include "config/entries/operator_answer.hpp"
#include "config/entries/robot_orders.hpp"
#include "config/entries/trajectory_entry.hpp"
#include "config/text/message_text.hpp"

namespace mrroc::config {

namespace {

void read_answer_of_sensor(const Table& table, const Deployment& deployment, Event& event) {
  std::vector<std::string> known;
  for (const SensorEntry& sensor : deployment.sensors)
    if (asks_operator(sensor)) known.push_back(sensor.name);
  if (known.empty())
    table.fail("command", "'answer' where no sensor asks the operator",
               "a sensor of type 'operator_input', or the key 'process' of a task program that asks");
  const SensorEntry& sensor = deployment.sensor(table.choice("sensor", known));
  event.asker = sensor.name;
  event.value = table.number("value", answers_of(sensor));
}

/// The process compares the value with its question when the answer arrives.
void read_answer_of_process(const Table& table, const Deployment& deployment, Event& event) {
  if (table.has("sensor")) table.fail("sensor", "is given beside 'process'", "one of the two");
  std::vector<std::string> known{"mp"};
  for (const RobotEntry& robot : deployment.robots) known.push_back(robot.name);
  event.asker = table.choice("process", known);
  event.value = table.number("value");
}

/// Keys of other commands.
void refuse_keys(const Table& table, const std::string& command, std::initializer_list<const char*> keys) {
  for (const char* key : keys)
    if (table.has(key))
      table.fail(key, "is not a key of the command " + in_quotes(command), "another command beside it");
}

Event read_trajectory_event(const Table& table, const Deployment& deployment, Event event) {
  refuse_keys(
      table, event.command,
      {"sensor", "process", "question", "value", "axis", "in", "velocity", "distance", "posture", "output", "tool"});
  std::vector<std::string> robots;
  for (const RobotEntry& robot : deployment.robots) robots.push_back(robot.name);
  event.order.robot = table.choice("robot", robots);
  if (event.command == "follow")
    event.trajectory = read_trajectory(table, parameters_of(deployment.robot(event.order.robot)).axes.size());
  else
    refuse_keys(table, event.command, {"points", "path_tolerance", "goal_tolerance", "goal_time_tolerance"});
  return event;
}

Event read_event(const Table& table, const Deployment& deployment) {
  table.only({"tick", "command", "sensor", "process", "value", "question", "robot", "axis", "in", "velocity",
              "distance", "posture", "output", "tool", "points", "path_tolerance", "goal_tolerance",
              "goal_time_tolerance"});
  Event event;
  event.tick = static_cast<Tick>(table.integer("tick", 0, std::numeric_limits<std::int64_t>::max()));
  event.command = table.choice("command", {"start",   "pause",  "resume", "trigger", "stop",   "estop", "reset",
                                           "speed",   "answer", "jog",    "step",    "go",     "hold",  "synchronise",
                                           "recover", "bias",   "output", "tool",    "follow", "cancel"});
  if (event.command == "follow" || event.command == "cancel") return read_trajectory_event(table, deployment, event);
  refuse_keys(table, event.command, {"points", "path_tolerance", "goal_tolerance", "goal_time_tolerance"});
  if (is_robot_order(event.command)) {
    refuse_keys(table, event.command, {"sensor", "process", "question"});
    event.order = read_robot_order(table, event.command, deployment);
    return event;
  }
  refuse_keys(table, event.command, {"robot", "axis", "in", "velocity", "distance", "posture", "output", "tool"});
  if (event.command == "answer") {
    if (table.has("process"))
      read_answer_of_process(table, deployment, event);
    else
      read_answer_of_sensor(table, deployment, event);
    event.question = static_cast<std::uint64_t>(table.integer_or("question", 0, 0, std::numeric_limits<int>::max()));
    return event;
  }
  refuse_keys(table, event.command, {"sensor", "process", "question"});
  if (event.command == "speed")
    event.value = table.number("value", {kLeastSpeedPercent, kFullSpeedPercent});
  else
    refuse_keys(table, event.command, {"value"});
  return event;
}

}  // namespace

std::vector<Event> read_events(const Table& root, const Deployment& deployment) {
  std::vector<Event> events;
  for (const Table& table : root.tables("events")) events.push_back(read_event(table, deployment));
  std::stable_sort(events.begin(), events.end(), [](const Event& a, const Event& b) { return a.tick < b.tick; });
  return events;
}

std::vector<Event> load_events(const std::filesystem::path& file, const Deployment& deployment) {
  const Table root = Table::load(file);
  root.only({"events"});
  return read_events(root, deployment);
}

}  // namespace mrroc::config
