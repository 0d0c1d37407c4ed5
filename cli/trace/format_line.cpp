#include "cli/trace/format_line.hpp"

#include <array>
#include <charconv>

#include "process/record/trace_words.hpp"

namespace mrroc::cli::trace {

namespace {

std::string text_of(double value) {
  std::array<char, 40> digits{};
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr};
}

std::string text_of(const Numbers& numbers) {
  std::string text;
  for (std::size_t i = 0; i < numbers.size(); ++i) text.append(i == 0 ? "" : ",").append(text_of(numbers[i]));
  return text;
}

std::string field(const char* name, std::uint64_t value) { return std::string{name} + std::to_string(value); }

std::string field(const char* name, const Numbers& values) { return name + text_of(values); }

std::string text_of(ErrorClass error, const std::string& code) {
  return error == ErrorClass::none ? "" : std::string{" error=\""}.append(describe(error)) + ": " + code + "\"";
}

std::string target_of(const CommandEntry& command) {
  if (command.kind == CommandKind::query || command.kind == CommandKind::hold || command.kind == CommandKind::set_tool)
    return "";
  if (command.kind != CommandKind::force) return std::string{":"} + text_of(command.target);
  const auto middle = command.target.begin() + 6;
  return std::string{":"} + text_of(Numbers(command.target.begin(), middle)) + "," + command.behaviour + "," +
         text_of(Numbers(middle, command.target.end()));
}

std::string text_of(const char* field_name, const CommandEntry& command) {
  std::string text = std::string{field_name}.append(process::word_of(process::kCommandWords, command.kind));
  if (command.relative) text += ",relative";
  if (command.interpolation == Interpolation::motors) text += ",motors";
  if (command.interpolation == Interpolation::task) text += ",task";
  text += field(",N", command.motion_steps) + field(",v", command.reply_step);
  if (command.start_tick != 0) text += field(",start", command.start_tick);
  return text + target_of(command);
}

std::string text_of(const RobotEntry& robot) {
  std::string text = " robot=" + robot.name + field(" tick=", robot.tick) + field(" macrostep=", robot.macrostep) +
                     field(" joints=", robot.joints) + field(" pose=", robot.pose) +
                     field(" desired_tick=", robot.desired_tick) + field(" desired=", robot.desired) +
                     field(" desired_pose=", robot.desired_pose);
  if (robot.moving) text += " moving";
  if (robot.coordination == Coordination::takes_part) text += " coordinated";
  if (robot.coordination == Coordination::left) text += " left";
  if (robot.late != 0) text += field(" late=", robot.late);
  if (!robot.wrench.empty()) text += field(" wrench=", robot.wrench);
  if (robot.lost != 0) text += field(" lost=", Numbers{robot.lost});
  text += text_of(robot.error, robot.error_code);
  if (robot.command) text += text_of(" command=", *robot.command);
  return robot.superior ? text + text_of(" superior=", *robot.superior) : text;
}

std::string text_of(const SensorEntry& sensor) {
  std::string text = " sensor=" + sensor.name + field(" tick=", sensor.tick) + field(" values=", sensor.values);
  if (sensor.period != 1) text += field(" period=", sensor.period);
  if (sensor.mode == SensorMode::published) text += " published";
  if (sensor.mode == SensorMode::polled) text += " polled";
  if (sensor.configuration != 0) text += field(" configuration=", sensor.configuration);
  if (sensor.configured != 0) text += field(" configured=", sensor.configured);
  return text + text_of(sensor.error, sensor.error_code);
}

}  // namespace

std::string format_line(const Line& line) {
  std::string text = field("tick=", line.tick) + " process=" + line.process + field(" instruction=", line.instruction) +
                     (line.is_move ? " move=\"" : " wait=\"") + line.name + "\"";
  if (line.until) text += " until=\"" + *line.until + "\"";
  text += field(" step=", line.step);
  if (line.held != 0) text += field(" held=", line.held);
  if (line.obtained) text += " obtained";
  for (const RobotEntry& robot : line.robots) text += text_of(robot);
  for (const SensorEntry& sensor : line.sensors) text += text_of(sensor);
  for (const ConditionEntry& condition : line.conditions)
    text += " condition=\"" + condition.name + (condition.value ? "\":1" : "\":0");
  if (line.ends()) text += std::string{" end="}.append(process::word_of(process::kEndingWords, line.ending));
  if (line.skew) text += field(" skew=", *line.skew);
  return text;
}

std::string format_remark(const Remark& remark) {
  return "# process=" + remark.process + field(" lines=", remark.lines) + field(" dropped=", remark.dropped) +
         field(" cut=", remark.cut);
}

}  // namespace mrroc::cli::trace
