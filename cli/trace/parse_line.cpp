#include "cli/trace/parse_line.hpp"

#include <array>
#include <cmath>
#include <utility>

#include "process/record/trace_words.hpp"

namespace mrroc::cli::trace {

namespace {

constexpr double kUnitLength = 1e-6;  // tolerance of a quaternion's length

constexpr process::TraceWords<ErrorClass, 3> kClasses{
    {{"non-fatal", ErrorClass::non_fatal}, {"hardware", ErrorClass::hardware}, {"system", ErrorClass::system}}};

template <class Value, std::size_t N>
Value one_of(const process::TraceWords<Value, N>& words, std::string_view found, std::string_view field) {
  std::string known;
  for (const auto& [word, value] : words) {
    if (word == found) return value;
    known.append(known.empty() ? "one of " : ", ").append(word);
  }
  throw Malformed(field, found, known);
}

void require_rotation(const Numbers& pose, std::string_view field) {
  const double length = std::sqrt(pose[3] * pose[3] + pose[4] * pose[4] + pose[5] * pose[5] + pose[6] * pose[6]);
  if (!(std::abs(length - 1) <= kUnitLength))
    throw Malformed(field, std::to_string(length), "a quaternion of length 1 behind the position");
}

Numbers take_pose(Fields& fields, std::string_view field) {
  Numbers pose = fields.finite_numbers(field, 7);
  require_rotation(pose, field);
  return pose;
}

ErrorClass take_error(Fields& fields, std::string& code) {
  if (!fields.take(" error=\"")) return ErrorClass::none;
  const ErrorClass found = one_of(kClasses, fields.word(), "error");
  fields.expect(" error: ", "error");
  code = fields.up_to({"\""}, "error");
  fields.take("\"");
  return found;
}

/// The twist, a letter per axis ("u" ... "c"), the wrench.
void parse_force(std::string_view text, CommandEntry& command) {
  std::array<std::string_view, 13> parts;
  std::size_t count = 0;
  for (std::string_view rest = text; count < parts.size(); ++count) {
    parts[count] = rest.substr(0, rest.find(','));
    if (parts[count].size() == rest.size()) break;
    rest.remove_prefix(parts[count].size() + 1);
  }
  const std::string_view behaviour = parts[6];
  if (count != 12 || behaviour.size() != 6 || behaviour.find_first_not_of("ugc?") != std::string_view::npos)
    throw Malformed("command", text, "6 velocities, 6 letters, 6 forces and torques");
  command.behaviour = behaviour;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i == 6) continue;
    const Numbers number = parse_numbers(parts[i], "command");
    if (number.size() != 1) throw Malformed("command", parts[i], "a number");
    command.target.push_back(number.front());
  }
}

void parse_target(std::string_view text, CommandEntry& command) {
  if (command.kind == CommandKind::force) return parse_force(text, command);
  command.target = parse_numbers(text, "command");
  const std::size_t found = command.target.size();
  const std::size_t size = command.kind == CommandKind::pose ? 7 : command.kind == CommandKind::twist ? 6 : found;
  if (found != size) throw Malformed("command", text, std::to_string(size) + " numbers behind the colon");
}

/// KIND[,relative][,motors|,task],N10,v8[,start248][:TARGET]
CommandEntry parse_command(std::string_view text) {
  CommandEntry command;
  const std::size_t colon = text.find(':');
  std::string_view head = text.substr(0, colon);
  const auto next = [&head] {
    const std::string_view part = head.substr(0, head.find(','));
    head.remove_prefix(std::min(part.size() + 1, head.size()));
    return part;
  };
  const auto number = [](std::string_view part, std::string_view letters) {
    if (!part.starts_with(letters)) throw Malformed("command", part, std::string{letters}.append(" and a number"));
    return parse_count(part.substr(letters.size()), "command");
  };
  command.kind = one_of(process::kCommandWords, next(), "command");
  std::string_view part = next();
  if (part == "relative") command.relative = true, part = next();
  if (part == "motors") command.interpolation = Interpolation::motors, part = next();
  if (part == "task") command.interpolation = Interpolation::task, part = next();
  command.motion_steps = number(part, "N");
  command.reply_step = number(next(), "v");
  if (!head.empty()) command.start_tick = number(next(), "start");
  if (!head.empty()) throw Malformed("command", head, "a colon and the target, or nothing");
  const bool aims =
      command.kind != CommandKind::query && command.kind != CommandKind::hold && command.kind != CommandKind::set_tool;
  if (aims != (colon != std::string_view::npos)) throw Malformed("command", text, aims ? "a target" : "no target");
  if (aims) parse_target(text.substr(colon + 1), command);
  return command;
}

RobotEntry take_robot(Fields& fields) {
  RobotEntry robot;
  robot.name = fields.name("robot");
  fields.expect(" tick=", "robot");
  robot.tick = fields.count("tick");
  fields.expect(" macrostep=", "robot");
  robot.macrostep = fields.count("macrostep");
  fields.expect(" joints=", "robot");
  robot.joints = fields.finite_numbers("joints", 0);
  fields.expect(" pose=", "robot");
  robot.pose = take_pose(fields, "pose");
  fields.expect(" desired_tick=", "robot");
  robot.desired_tick = fields.count("desired_tick");
  fields.expect(" desired=", "robot");
  robot.desired = fields.finite_numbers("desired", robot.joints.size());
  fields.expect(" desired_pose=", "robot");
  robot.desired_pose = take_pose(fields, "desired_pose");
  robot.moving = fields.take(" moving");
  if (fields.take(" coordinated")) robot.coordination = Coordination::takes_part;
  if (fields.take(" left")) robot.coordination = Coordination::left;
  if (fields.take(" late=")) robot.late = fields.count("late");
  if (fields.take(" wrench=")) robot.wrench = fields.finite_numbers("wrench", 6);
  if (fields.take(" lost=")) robot.lost = fields.finite_numbers("lost", 1)[0];
  robot.error = take_error(fields, robot.error_code);
  if (fields.take(" command=")) robot.command = parse_command(fields.word());
  if (fields.take(" superior=")) robot.superior = parse_command(fields.word());
  return robot;
}

SensorEntry take_sensor(Fields& fields) {
  SensorEntry sensor;
  sensor.name = fields.name("sensor");
  fields.expect(" tick=", "sensor");
  sensor.tick = fields.count("tick");
  fields.expect(" values=", "sensor");
  sensor.values = fields.numbers("values");
  if (fields.take(" period=")) sensor.period = fields.count("period");
  if (sensor.period == 0) throw Malformed("period", "0", "at least 1");
  if (fields.take(" published")) sensor.mode = SensorMode::published;
  if (fields.take(" polled")) sensor.mode = SensorMode::polled;
  if (fields.take(" configuration=")) sensor.configuration = fields.count("configuration");
  if (fields.take(" configured=")) sensor.configured = fields.count("configured");
  sensor.error = take_error(fields, sensor.error_code);
  return sensor;
}

ConditionEntry take_condition(Fields& fields) {
  ConditionEntry condition;
  condition.name = fields.up_to({"\":0", "\":1"}, "condition");
  fields.take("\":");
  condition.value = fields.word() == "1";
  return condition;
}

void take_head(Fields& fields, Line& line) {
  fields.expect("tick=", "tick");
  line.tick = fields.count("tick");
  fields.expect(" process=", "process");
  line.process = fields.name("process");
  fields.expect(" instruction=", "instruction");
  line.instruction = fields.count("instruction");
  line.is_move = fields.take(" move=\"");
  if (!line.is_move) fields.expect(" wait=\"", "move or wait");
  line.name = fields.up_to({"\" step=", "\" until=\""}, "name");
  if (line.is_move && fields.take("\" until=\"")) line.until = fields.up_to({"\" step="}, "until");
  fields.expect("\" step=", "step");
  line.step = fields.count("step");
}

void take_rest(Fields& fields, Line& line) {
  if (fields.take(" held=")) line.held = fields.count("held");
  line.obtained = fields.take(" obtained");
  while (fields.take(" robot=")) line.robots.push_back(take_robot(fields));
  while (fields.take(" sensor=")) line.sensors.push_back(take_sensor(fields));
  while (fields.take(" condition=\"")) line.conditions.push_back(take_condition(fields));
  if (fields.take(" end=")) line.ending = one_of(process::kEndingWords, fields.word(), "end");
  if (fields.take(" skew=")) line.skew = fields.count("skew");
  if (!fields.at_end()) {
    fields.take(" ");
    throw Malformed("behind the last field", fields.word(), "the end of the line");
  }
}

}  // namespace

Line parse_line(std::string_view text, std::size_t longest) {
  Line line;
  Fields fields(text);
  take_head(fields, line);
  line.cut = text.size() >= longest;
  if (!line.cut) take_rest(fields, line);
  return line;
}

}  // namespace mrroc::cli::trace
