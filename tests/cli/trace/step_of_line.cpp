#include "cli/trace/step_of_line.hpp"

#include "recording/recorded_time.hpp"

namespace mrroc::cli::trace {

namespace {

using messages::mrroc_msgs::Command;
using messages::mrroc_msgs::RobotState;
using messages::mrroc_msgs::SensorReading;

messages::geometry_msgs::Pose to_pose(const Numbers& numbers) {
  messages::geometry_msgs::Pose pose;
  pose.position = {numbers[0], numbers[1], numbers[2]};
  pose.orientation = {numbers[4], numbers[5], numbers[6], numbers[3]};
  return pose;
}

Command to_command(const CommandEntry& entry) {
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

RobotState to_robot(const RobotEntry& entry) {
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

SensorReading to_reading(const SensorEntry& entry) {
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

}  // namespace

messages::mrroc_msgs::Step to_message(const Line& line, std::uint64_t period) {
  messages::mrroc_msgs::Step step;
  step.stamp = recording::stamp_of(line.tick, period);
  step.tick = line.tick;
  step.process = line.process;
  step.instruction = line.instruction;
  step.is_move = line.is_move;
  step.name = line.name;
  if (line.until) step.until.push_back(*line.until);
  step.step_number = line.step;
  step.held = line.held;
  step.obtained = line.obtained;
  for (const RobotEntry& robot : line.robots) step.robots.push_back(to_robot(robot));
  for (const SensorEntry& sensor : line.sensors) step.sensors.push_back(to_reading(sensor));
  for (const ConditionEntry& condition : line.conditions) step.conditions.push_back({condition.name, condition.value});
  step.ending = static_cast<std::uint8_t>(line.ending);
  if (line.skew) step.skew.push_back(*line.skew);
  step.cut = line.cut;
  return step;
}

}  // namespace mrroc::cli::trace
