#include <algorithm>

#include "cli/trace/condition_value.hpp"
#include "cli/trace/mutations.hpp"

namespace mrroc::cli::trace {

namespace {

using Suits = std::function<bool(const TraceSteps&, std::size_t)>;
using Change = std::function<void(Line&, Random&)>;

Mutation of_line(const char* name, Suits suits, Change change) {
  return {name, [suits, change](TraceSteps& trace, Random& random) {
            const auto place = pick_line(trace, random, [&](std::size_t i) { return suits(trace, i); });
            if (place) change(trace.line(*place), random);
            return place.has_value();
          }};
}

PossibleValues value_of(const Line& line) {
  return value_of_condition(line.is_move ? line.until.value_or("") : line.name, line.conditions);
}

/// A part whose other value would decide: the condition would hold where the instruction continues, or not hold where
/// it ended the instruction. A part of an `and` whose other parts are false, or of an `or` that holds anyway, decides
/// nothing.
std::vector<std::size_t> deciding_parts(const Line& line) {
  std::vector<std::size_t> parts;
  for (std::size_t i = 0; i < line.conditions.size(); ++i) {
    Line other = line;
    other.conditions[i].value = !other.conditions[i].value;
    const PossibleValues value = value_of(other);
    if (line.ending == StepEnding::condition ? value.is_false() : value.is_true()) parts.push_back(i);
  }
  return parts;
}

void flip_deciding_part(Line& line, Random& random) {
  const std::vector<std::size_t> parts = deciding_parts(line);
  ConditionEntry& part = line.conditions[parts[pick(random, 0, parts.size() - 1)]];
  part.value = !part.value;
}

bool has_deciding_part(const TraceSteps& trace, std::size_t i) { return !deciding_parts(trace.line(i)).empty(); }

bool ends(const TraceSteps& trace, std::size_t i) { return trace.line(i).ends(); }
bool ends_with_states(const TraceSteps& trace, std::size_t i) {
  return ends(trace, i) && !trace.line(i).robots.empty();
}

bool goes_on_with_robots(const TraceSteps& trace, std::size_t i) {
  return !trace.line(i).ends() && !trace.line(i).robots.empty() && line_behind(trace, i) != kNoLine;
}

/// The end of a Move without a condition by its generator may also be an end by the operator, or by its own error.
bool shows_parts_at_end(const TraceSteps& trace, std::size_t i) {
  return ends(trace, i) && !trace.line(i).conditions.empty();
}

template <class Chosen>
std::vector<std::size_t> sensors_of(const TraceSteps& trace, std::size_t i, Chosen chosen) {
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < trace.line(i).sensors.size(); ++k)
    if (chosen(k)) found.push_back(k);
  return found;
}

Mutation of_sensor(const char* name, std::function<bool(const TraceSteps&, std::size_t, std::size_t)> suits,
                   std::function<void(SensorEntry&, Random&)> change) {
  return {name, [suits, change](TraceSteps& trace, Random& random) {
            const auto chosen = [&](std::size_t i) {
              return sensors_of(trace, i, [&](std::size_t k) { return suits(trace, i, k); });
            };
            const auto place = pick_line(trace, random, [&](std::size_t i) { return !chosen(i).empty(); });
            if (!place) return false;
            const std::vector<std::size_t> sensors = chosen(*place);
            change(trace.line(*place).sensors[sensors[pick(random, 0, sensors.size() - 1)]], random);
            return true;
          }};
}

bool due(const Line& line, const SensorEntry& sensor) { return line.held != 0 || line.step % sensor.period == 0; }

bool is_due_interactive(const TraceSteps& trace, std::size_t i, std::size_t k) {
  const Line& line = trace.line(i);
  const SensorEntry& sensor = line.sensors[k];
  return sensor.mode == SensorMode::interactive && due(line, sensor) && !line.broken_off() &&
         sensor.error == ErrorClass::none && (!line.robots.empty() || line_before(trace, i) != kNoLine);
}

bool is_not_due(const TraceSteps& trace, std::size_t i, std::size_t k) {
  const Line& line = trace.line(i);
  return !due(line, line.sensors[k]) && !line.broken_off() && line_before(trace, i) != kNoLine &&
         !line.sensors[k].values.empty();
}

bool is_one_of_several(const TraceSteps& trace, std::size_t i, std::size_t) { return line_behind(trace, i) != kNoLine; }

}  // namespace

std::vector<Mutation> mutations_of_conditions() {
  return {
      of_line("another value of a part that decides", has_deciding_part, flip_deciding_part),
      of_line(
          "a part that has gone",
          [](const TraceSteps& trace, std::size_t i) {
            return !trace.line(i).conditions.empty() && line_before(trace, i) != kNoLine;
          },
          [](Line& line, Random&) { line.conditions.pop_back(); }),
      of_line("no end", ends_with_states,
              [](Line& line, Random&) {
                line.ending = StepEnding::none;
                line.skew.reset();
              }),
      of_line("an end where it went on", goes_on_with_robots,
              [](Line& line, Random&) {
                line.ending = StepEnding::generator;
                for (RobotEntry& robot : line.robots) robot.command.reset();
              }),
      of_line("an end by the operator", shows_parts_at_end,
              [](Line& line, Random&) { line.ending = StepEnding::end_motion; }),
      of_line("an end by an error", shows_parts_at_end,
              [](Line& line, Random&) { line.ending = StepEnding::non_fatal_error; }),
      of_line(
          "an end by a condition that does not hold, or is not there",
          [](const TraceSteps& trace, std::size_t i) {
            const Line& line = trace.line(i);
            return line.ends() && line.ending != StepEnding::condition &&
                   (line.conditions.empty() || value_of(line).is_false());
          },
          [](Line& line, Random&) { line.ending = StepEnding::condition; }),
      of_line(
          "an end by a generator instead of the condition",
          [](const TraceSteps& trace, std::size_t i) {
            return trace.line(i).ending == StepEnding::condition && value_of(trace.line(i)).is_true();
          },
          [](Line& line, Random&) { line.ending = StepEnding::generator; }),
      of_line(
          "another skew",
          [](const TraceSteps& trace, std::size_t i) {
            return trace.line(i).skew.has_value() && !trace.line(i).broken_off();
          },
          [](Line& line, Random& random) { *line.skew += pick(random, 1, 5); }),
      of_sensor(
          "an old reading", is_due_interactive,
          [](SensorEntry& sensor, Random& random) { sensor.tick -= pick(random, 1, std::min<Tick>(10, sensor.tick)); }),
      of_sensor("a new value where none is due", is_not_due,
                [](SensorEntry& sensor, Random&) { sensor.values.front() += 0.5; }),
      of_sensor("a new reading where none is due", is_not_due, [](SensorEntry& sensor, Random&) { ++sensor.tick; }),
      of_sensor(
          "a reading of the configuration before", [](const TraceSteps&, std::size_t, std::size_t) { return true; },
          [](SensorEntry& sensor, Random& random) { sensor.configured = sensor.configuration + pick(random, 1, 3); }),
      of_sensor("another period", is_one_of_several, [](SensorEntry& sensor, Random&) { ++sensor.period; }),
      of_sensor("another mode", is_one_of_several,
                [](SensorEntry& sensor, Random&) {
                  sensor.mode = sensor.mode == SensorMode::polled ? SensorMode::interactive : SensorMode::polled;
                }),
      of_sensor("one value more", is_one_of_several, [](SensorEntry& sensor, Random&) { sensor.values.push_back(0); }),
      of_sensor("another sensor", is_one_of_several, [](SensorEntry& sensor, Random&) { sensor.name += "2"; }),
      of_sensor(
          "an error that does not end it",
          [](const TraceSteps& trace, std::size_t i, std::size_t) { return !trace.line(i).ends(); },
          [](SensorEntry& sensor, Random&) {
            sensor.error = ErrorClass::hardware;
            sensor.error_code = "the sensor hardware malfunctions";
          }),
  };
}

}  // namespace mrroc::cli::trace
