#include "cli/record/step_message.hpp"

#include <algorithm>
#include <string>

#include "cli/trace/fields.hpp"

namespace mrroc::cli::record {

namespace {

using messages::mrroc_msgs::Command;
using messages::mrroc_msgs::RobotState;
using messages::mrroc_msgs::SensorReading;
using messages::mrroc_msgs::Step;
using trace::Malformed;

// the numbers of the messages are those of the enumerations, which a recording must not follow when they change
static_assert(Command::QUERY == static_cast<int>(CommandKind::query));
static_assert(Command::FORCE == static_cast<int>(CommandKind::force));
static_assert(Command::CHANGE == static_cast<int>(CommandKind::set_tool));
static_assert(Command::TASK == static_cast<int>(Interpolation::task));
static_assert(RobotState::LEFT == static_cast<int>(Coordination::left));
static_assert(RobotState::SYSTEM == static_cast<int>(ErrorClass::system));
static_assert(SensorReading::PUBLISHED == static_cast<int>(trace::SensorMode::published));
static_assert(Step::SYSTEM_ERROR == static_cast<int>(StepEnding::system_error));

constexpr std::size_t kForceTarget = 12, kForceBehaviour = 6;
constexpr std::size_t kPoseSize = 7, kTwistSize = 6;

template <class Value>
Value checked(std::uint8_t number, Value last, std::string_view field) {
  if (number > static_cast<std::uint8_t>(last))
    throw Malformed(field, std::to_string(number), "0 to " + std::to_string(static_cast<int>(last)));
  return static_cast<Value>(number);
}

messages::geometry_msgs::Pose to_pose(const trace::Numbers& numbers) {
  messages::geometry_msgs::Pose pose;
  pose.position = {numbers[0], numbers[1], numbers[2]};
  pose.orientation = {numbers[4], numbers[5], numbers[6], numbers[3]};
  return pose;
}

trace::Numbers to_numbers(const messages::geometry_msgs::Pose& pose) {
  return {pose.position.x,    pose.position.y,    pose.position.z,   pose.orientation.w,
          pose.orientation.x, pose.orientation.y, pose.orientation.z};
}

Command to_command(const trace::CommandEntry& entry) {
  Command command;
  command.kind = static_cast<std::uint8_t>(entry.kind);
  command.relative = entry.relative;
  command.interpolation = static_cast<std::uint8_t>(entry.interpolation);
  command.motion_steps = entry.motion_steps;
  command.reply_step = entry.reply_step;
  command.start_tick = entry.start_tick;
  command.target = entry.target;
  command.behaviour = entry.behaviour;
  return command;
}

std::size_t size_of_target(CommandKind kind, std::size_t found) noexcept {
  if (kind == CommandKind::pose) return kPoseSize;
  if (kind == CommandKind::twist) return kTwistSize;
  if (kind == CommandKind::force) return kForceTarget;
  const bool aims = kind != CommandKind::query && kind != CommandKind::hold && kind != CommandKind::set_tool;
  return aims ? found : 0;
}

trace::CommandEntry to_entry(const Command& command) {
  trace::CommandEntry entry;
  entry.kind = checked(command.kind, CommandKind::set_tool, "command.kind");
  entry.relative = command.relative;
  entry.interpolation = checked(command.interpolation, Interpolation::task, "command.interpolation");
  entry.motion_steps = command.motion_steps;
  entry.reply_step = command.reply_step;
  entry.start_tick = command.start_tick;
  entry.target = command.target;
  entry.behaviour = command.behaviour;
  const std::size_t size = size_of_target(entry.kind, entry.target.size());
  if (entry.target.size() != size)
    throw Malformed("command.target", std::to_string(entry.target.size()) + " numbers",
                    std::to_string(size) + " numbers");
  const std::size_t letters = entry.kind == CommandKind::force ? kForceBehaviour : 0;
  if (entry.behaviour.size() != letters)
    throw Malformed("command.behaviour", entry.behaviour, std::to_string(letters) + " letters");
  return entry;
}

RobotState to_robot(const trace::RobotEntry& entry) {
  RobotState robot;
  robot.name = entry.name;
  robot.tick = entry.tick;
  robot.macrostep_start = entry.macrostep;
  robot.joints = entry.joints;
  robot.pose = to_pose(entry.pose);
  robot.desired_tick = entry.desired_tick;
  robot.desired_joints = entry.desired;
  robot.desired_pose = to_pose(entry.desired_pose);
  robot.moving = entry.moving;
  robot.coordination = static_cast<std::uint8_t>(entry.coordination);
  robot.late_commands = entry.late;
  robot.wrench = entry.wrench;
  robot.lost = entry.lost;
  robot.error_class = static_cast<std::uint8_t>(entry.error);
  robot.error = entry.error_code;
  if (entry.command) robot.command.push_back(to_command(*entry.command));
  if (entry.superior) robot.superior.push_back(to_command(*entry.superior));
  return robot;
}

trace::RobotEntry to_entry(const RobotState& robot) {
  trace::RobotEntry entry;
  entry.name = robot.name;
  entry.tick = robot.tick;
  entry.macrostep = robot.macrostep_start;
  entry.joints = robot.joints;
  entry.pose = to_numbers(robot.pose);
  entry.desired_tick = robot.desired_tick;
  entry.desired = robot.desired_joints;
  entry.desired_pose = to_numbers(robot.desired_pose);
  entry.moving = robot.moving;
  entry.coordination = checked(robot.coordination, Coordination::left, "robot.coordination");
  entry.late = robot.late_commands;
  entry.wrench = robot.wrench;
  entry.lost = robot.lost;
  entry.error = checked(robot.error_class, ErrorClass::system, "robot.error_class");
  entry.error_code = robot.error;
  if (!robot.command.empty()) entry.command = to_entry(robot.command.front());
  if (!robot.superior.empty()) entry.superior = to_entry(robot.superior.front());
  return entry;
}

SensorReading to_reading(const trace::SensorEntry& entry) {
  SensorReading reading;
  reading.name = entry.name;
  reading.tick = entry.tick;
  reading.values = entry.values;
  reading.period = entry.period;
  reading.mode = static_cast<std::uint8_t>(entry.mode);
  reading.configuration = entry.configuration;
  reading.configured = entry.configured;
  reading.error_class = static_cast<std::uint8_t>(entry.error);
  reading.error = entry.error_code;
  return reading;
}

trace::SensorEntry to_entry(const SensorReading& reading) {
  trace::SensorEntry entry;
  entry.name = reading.name;
  entry.tick = reading.tick;
  entry.values = reading.values;
  entry.period = reading.period;
  entry.mode = checked(reading.mode, trace::SensorMode::published, "sensor.mode");
  entry.configuration = reading.configuration;
  entry.configured = reading.configured;
  entry.error = checked(reading.error_class, ErrorClass::system, "sensor.error_class");
  entry.error_code = reading.error;
  return entry;
}

}  // namespace

messages::builtin_interfaces::Time stamp_at(std::uint64_t time) noexcept {
  constexpr std::uint64_t kSecond = 1'000'000'000;
  messages::builtin_interfaces::Time stamp;
  stamp.sec = static_cast<std::int32_t>(time / kSecond);
  stamp.nanosec = static_cast<std::uint32_t>(time % kSecond);
  return stamp;
}

Step to_message(const trace::Line& line, std::uint64_t period) {
  Step step;
  step.stamp = stamp_of(line.tick, period);
  step.tick = line.tick;
  step.process = line.process;
  step.instruction = line.instruction;
  step.is_move = line.is_move;
  step.name = line.name;
  if (line.until) step.until.push_back(*line.until);
  step.step_number = line.step;
  step.held = line.held;
  step.obtained = line.obtained;
  for (const trace::RobotEntry& robot : line.robots) step.robots.push_back(to_robot(robot));
  for (const trace::SensorEntry& sensor : line.sensors) step.sensors.push_back(to_reading(sensor));
  for (const trace::ConditionEntry& condition : line.conditions)
    step.conditions.push_back({condition.name, condition.value});
  step.ending = static_cast<std::uint8_t>(line.ending);
  if (line.skew) step.skew.push_back(*line.skew);
  step.cut = line.cut;
  return step;
}

trace::Line to_line(const Step& step) {
  trace::Line line;
  line.tick = step.tick;
  line.process = step.process;
  line.instruction = step.instruction;
  line.is_move = step.is_move;
  line.name = step.name;
  if (!step.until.empty()) line.until = step.until.front();
  line.step = step.step_number;
  line.held = step.held;
  line.obtained = step.obtained;
  for (const RobotState& robot : step.robots) line.robots.push_back(to_entry(robot));
  for (const SensorReading& sensor : step.sensors) line.sensors.push_back(to_entry(sensor));
  for (const messages::mrroc_msgs::Condition& condition : step.conditions)
    line.conditions.push_back({condition.name, condition.holds});
  line.ending = checked(step.ending, StepEnding::system_error, "ending");
  if (!step.skew.empty()) line.skew = step.skew.front();
  line.cut = step.cut;
  return line;
}

}  // namespace mrroc::cli::record
