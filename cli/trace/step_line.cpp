#include "cli/trace/step_line.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "cli/trace/malformed.hpp"

namespace mrroc::cli::trace {

namespace {

using messages::mrroc_msgs::Command;
using messages::mrroc_msgs::RobotState;
using messages::mrroc_msgs::SensorReading;
using StepMessage = messages::mrroc_msgs::Step;

// the numbers of the messages are those of the enumerations, which a recording must not follow when they change
static_assert(Command::QUERY == static_cast<int>(CommandKind::query));
static_assert(Command::FORCE == static_cast<int>(CommandKind::force));
static_assert(Command::CHANGE == static_cast<int>(CommandKind::set_tool));
static_assert(Command::TASK == static_cast<int>(Interpolation::task));
static_assert(RobotState::LEFT == static_cast<int>(Coordination::left));
static_assert(RobotState::SYSTEM == static_cast<int>(ErrorClass::system));
static_assert(SensorReading::PUBLISHED == static_cast<int>(SensorMode::published));
static_assert(StepMessage::SYSTEM_ERROR == static_cast<int>(StepEnding::system_error));

constexpr double kUnitLength = 1e-6;  // tolerance of a quaternion's length
constexpr std::size_t kForceTarget = 12, kForceBehaviour = 6;
constexpr std::size_t kPoseSize = 7, kTwistSize = 6, kWrenchSize = 6;

template <class Value>
Value checked(std::uint8_t number, Value last, std::string_view field) {
  if (number > static_cast<std::uint8_t>(last))
    throw Malformed(field, std::to_string(number), "0 to " + std::to_string(static_cast<int>(last)));
  return static_cast<Value>(number);
}

Numbers finite(Numbers numbers, std::string_view field) {
  for (const double number : numbers)
    if (!std::isfinite(number)) throw Malformed(field, std::to_string(number), "finite numbers");
  return numbers;
}

Numbers sized(Numbers numbers, std::size_t size, std::string_view field) {
  if (numbers.size() != size)
    throw Malformed(field, std::to_string(numbers.size()) + " numbers", std::to_string(size) + " numbers");
  return finite(std::move(numbers), field);
}

Numbers to_numbers(const messages::geometry_msgs::Pose& pose, std::string_view field) {
  const auto& [x, y, z, w] = pose.orientation;
  const double length = std::sqrt(w * w + x * x + y * y + z * z);
  if (!(std::abs(length - 1) <= kUnitLength))
    throw Malformed(field, std::to_string(length), "a quaternion of length 1 behind the position");
  return finite({pose.position.x, pose.position.y, pose.position.z, w, x, y, z}, field);
}

const std::string& name_of(const std::string& name, std::string_view field) {
  if (name.empty()) throw Malformed(field, name, "a name");
  return name;
}

std::size_t size_of_target(CommandKind kind, std::size_t found) noexcept {
  if (kind == CommandKind::pose) return kPoseSize;
  if (kind == CommandKind::twist) return kTwistSize;
  if (kind == CommandKind::force) return kForceTarget;
  const bool aims = kind != CommandKind::query && kind != CommandKind::hold && kind != CommandKind::set_tool;
  return aims ? found : 0;
}

CommandEntry to_entry(const Command& command) {
  CommandEntry entry;
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

RobotEntry to_entry(const RobotState& robot) {
  RobotEntry entry;
  entry.name = name_of(robot.name, "robot.name");
  entry.tick = robot.tick;
  entry.macrostep = robot.macrostep_start;
  entry.joints = finite(robot.joints, "robot.joints");
  entry.pose = to_numbers(robot.pose, "robot.pose");
  entry.desired_tick = robot.desired_tick;
  entry.desired = sized(robot.desired_joints, robot.joints.size(), "robot.desired_joints");
  entry.desired_pose = to_numbers(robot.desired_pose, "robot.desired_pose");
  entry.moving = robot.moving;
  entry.coordination = checked(robot.coordination, Coordination::left, "robot.coordination");
  entry.late = robot.late_commands;
  if (!robot.wrench.empty()) entry.wrench = sized(robot.wrench, kWrenchSize, "robot.wrench");
  entry.lost = finite({robot.lost}, "robot.lost").front();
  entry.error = checked(robot.error_class, ErrorClass::system, "robot.error_class");
  entry.error_code = robot.error;
  if (!robot.command.empty()) entry.command = to_entry(robot.command.front());
  if (!robot.superior.empty()) entry.superior = to_entry(robot.superior.front());
  return entry;
}

SensorEntry to_entry(const SensorReading& reading) {
  SensorEntry entry;
  entry.name = name_of(reading.name, "sensor.name");
  entry.tick = reading.tick;
  entry.values = reading.values;
  if (reading.period == 0) throw Malformed("sensor.period", "0", "at least 1");
  entry.period = reading.period;
  entry.mode = checked(reading.mode, SensorMode::published, "sensor.mode");
  entry.configuration = reading.configuration;
  entry.configured = reading.configured;
  entry.error = checked(reading.error_class, ErrorClass::system, "sensor.error_class");
  entry.error_code = reading.error;
  return entry;
}

}  // namespace

Line to_line(const messages::mrroc_msgs::Step& step) {
  Line line;
  line.tick = step.tick;
  line.process = name_of(step.process, "process");
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

}  // namespace mrroc::cli::trace
