#include "config/entries/events.hpp"

#include <algorithm>
#include <limits>

#include "config/entries/operator_answer.hpp"
#include "config/text/message_text.hpp"

namespace mrroc::config {

namespace {

const SensorEntry& asked_sensor(const Table& table, const Deployment& deployment) {
  std::vector<std::string> known;
  for (const SensorEntry& sensor : deployment.sensors)
    if (asks_operator(sensor)) known.push_back(sensor.name);
  if (known.empty())
    table.fail("command", "'answer' where nothing asks the operator", "a sensor of type 'operator_input'");
  return deployment.sensor(table.choice("sensor", known));
}

Event read_event(const Table& table, const Deployment& deployment) {
  table.only({"tick", "command", "sensor", "value"});
  Event event;
  event.tick = static_cast<Tick>(table.integer("tick", 0, std::numeric_limits<std::int64_t>::max()));
  event.command = table.choice("command", {"pause", "resume", "trigger", "stop", "estop", "reset", "answer"});
  if (event.command == "answer") {
    const SensorEntry& sensor = asked_sensor(table, deployment);
    event.sensor = sensor.name;
    event.value = table.number("value", answers_of(sensor));
    return event;
  }
  for (const char* key : {"sensor", "value"})
    if (table.has(key)) table.fail(key, in_quotes(event.command) + " answers nothing", "command = 'answer' beside it");
  return event;
}

}  // namespace

std::vector<Event> read_events(const Table& root, const Deployment& deployment) {
  std::vector<Event> events;
  for (const Table& table : root.tables("events")) events.push_back(read_event(table, deployment));
  std::stable_sort(events.begin(), events.end(), [](const Event& a, const Event& b) { return a.tick < b.tick; });
  return events;
}

}  // namespace mrroc::config
