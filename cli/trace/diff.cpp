#include "cli/trace/diff.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <deque>
#include <map>
#include <utility>
#include <variant>
#include <vector>

namespace mrroc::cli::trace {

namespace {

/// The fields of a step: name, value.
class FieldList {
 public:
  void add(std::string name, std::string value) { fields_.emplace_back(std::move(name), std::move(value)); }
  void add(std::string name, std::uint64_t value) { add(std::move(name), std::to_string(value)); }
  void add(const std::string& name, const Numbers& values) {
    add("number of " + name, values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      std::array<char, 40> digits{};
      char* const end = std::to_chars(digits.data(), digits.data() + digits.size(), values[i]).ptr;
      add(name + "[" + std::to_string(i) + "]", std::string(digits.data(), end));
    }
  }
  const std::vector<std::pair<std::string, std::string>>& all() const noexcept { return fields_; }

 private:
  std::vector<std::pair<std::string, std::string>> fields_;
};

std::string yes_or_no(bool value) { return value ? "yes" : "no"; }

void add_command(FieldList& fields, const std::string& name, const std::string& of,
                 const std::optional<CommandEntry>& command) {
  fields.add(name + of, std::string{command ? "given" : "missing"});
  if (!command) return;
  fields.add("kind of the " + name + of, static_cast<std::uint64_t>(command->kind));
  fields.add("relative of the " + name + of, yes_or_no(command->relative));
  fields.add("interpolation of the " + name + of, static_cast<std::uint64_t>(command->interpolation));
  fields.add("N of the " + name + of, command->motion_steps);
  fields.add("v of the " + name + of, command->reply_step);
  fields.add("start tick of the " + name + of, command->start_tick);
  fields.add("target of the " + name + of, command->target);
  fields.add("behaviour of the " + name + of, command->behaviour);
}

void add_robot(FieldList& fields, const RobotEntry& robot) {
  const std::string of = " of robot " + robot.name;
  fields.add("tick" + of, robot.tick);
  fields.add("macrostep" + of, robot.macrostep);
  fields.add("joints" + of, robot.joints);
  fields.add("pose" + of, robot.pose);
  fields.add("desired_tick" + of, robot.desired_tick);
  fields.add("desired" + of, robot.desired);
  fields.add("desired_pose" + of, robot.desired_pose);
  fields.add("moving" + of, yes_or_no(robot.moving));
  fields.add("coordination" + of, static_cast<std::uint64_t>(robot.coordination));
  fields.add("late" + of, robot.late);
  fields.add("wrench" + of, robot.wrench);
  fields.add("lost" + of, Numbers{robot.lost});
  fields.add("error" + of, robot.error == ErrorClass::none ? "none" : robot.error_code);
  add_command(fields, "command", of, robot.command);
  add_command(fields, "superior", of, robot.superior);
}

void add_sensor(FieldList& fields, const SensorEntry& sensor) {
  const std::string of = " of sensor " + sensor.name;
  fields.add("tick" + of, sensor.tick);
  fields.add("values" + of, sensor.values);
  fields.add("period" + of, sensor.period);
  fields.add("mode" + of, static_cast<std::uint64_t>(sensor.mode));
  fields.add("configuration" + of, sensor.configuration);
  fields.add("configured" + of, sensor.configured);
  fields.add("error" + of, sensor.error == ErrorClass::none ? "none" : sensor.error_code);
}

FieldList fields_of(const Line& line) {
  FieldList fields;
  fields.add("tick", line.tick);
  fields.add("instruction", line.instruction);
  fields.add(line.is_move ? "move" : "wait", line.name);
  fields.add("until", line.until.value_or("missing"));
  fields.add("step", line.step);
  fields.add("held", line.held);
  fields.add("obtained", yes_or_no(line.obtained));
  for (const RobotEntry& robot : line.robots) add_robot(fields, robot);
  for (const SensorEntry& sensor : line.sensors) add_sensor(fields, sensor);
  for (const ConditionEntry& condition : line.conditions)
    fields.add("condition \"" + condition.name + "\"", std::string{condition.value ? "1" : "0"});
  fields.add("ending", static_cast<std::uint64_t>(line.ending));
  fields.add("skew", line.skew ? std::to_string(*line.skew) : "missing");
  fields.add("too long", yes_or_no(line.cut));
  return fields;
}

std::string place_of(const Line& line) {
  return "process " + line.process + ", instruction " + std::to_string(line.instruction) + " (" + line.name +
         "), step " + std::to_string(line.step) + ", tick " + std::to_string(line.tick);
}

/// Nothing: all fields are equal.
std::optional<Difference> difference_of(const Line& first, const Line& second) {
  const FieldList one = fields_of(first), other = fields_of(second);
  for (std::size_t i = 0; i < std::max(one.all().size(), other.all().size()); ++i) {
    const bool in_one = i < one.all().size(), in_other = i < other.all().size();
    if (in_one && in_other && one.all()[i] == other.all()[i]) continue;
    const std::string name = in_one ? one.all()[i].first : other.all()[i].first;
    const bool same = in_one && in_other && one.all()[i].first == other.all()[i].first;
    return Difference{place_of(first), name, in_one ? one.all()[i].second : "missing",
                      same ? other.all()[i].second : std::string{"missing"}};
  }
  return std::nullopt;
}

/// Steps of one trace that wait for those of the other.
using Waiting = std::map<std::string, std::deque<Line>>;

/// The next step of a trace; none at its end.
std::optional<Line> next_line(Reader& reader) {
  for (;;) {
    auto item = reader.next();
    if (auto* line = std::get_if<Line>(&item)) return std::move(*line);
    if (std::holds_alternative<std::monostate>(item)) return std::nullopt;
  }
}

/// The step that comes first of those that have no counterpart.
const Line* earliest(const Waiting& waiting) {
  const Line* found = nullptr;
  for (const auto& [process, lines] : waiting)
    if (!lines.empty() && (found == nullptr || lines.front().tick < found->tick)) found = &lines.front();
  return found;
}

}  // namespace

Comparison compare(Reader& first, Reader& second) {
  Comparison comparison;
  Waiting ones, others;
  for (bool more = true; more;) {
    std::optional<Line> one = next_line(first), other = next_line(second);
    more = one || other;
    const std::string process = one ? one->process : other ? other->process : "";
    const std::string also = other ? other->process : process;
    if (one) ones[one->process].push_back(std::move(*one));
    if (other) others[other->process].push_back(std::move(*other));
    for (const std::string& name : {process, also}) {
      std::deque<Line>&a = ones[name], &b = others[name];
      for (; !a.empty() && !b.empty(); a.pop_front(), b.pop_front()) {
        comparison.difference = difference_of(a.front(), b.front());
        if (comparison.difference) return comparison;
        ++comparison.steps;
      }
    }
  }
  if (const Line* left = earliest(ones); left != nullptr)
    comparison.difference = {place_of(*left), "", "a step", "missing"};
  else if (left = earliest(others); left != nullptr)
    comparison.difference = {place_of(*left), "", "missing", "a step"};
  return comparison;
}

}  // namespace mrroc::cli::trace
