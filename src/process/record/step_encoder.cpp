#include "process/record/step_encoder.hpp"

#include <algorithm>
#include <array>

#include "messages/mrroc_msgs/sensor_reading.hpp"
#include "recording/recorded_time.hpp"

namespace mrroc::process {

namespace {

using messages::mrroc_msgs::SensorReading;

constexpr std::size_t kShortened = 1000;  // characters of a name in a step that is too long

void add_vector(EncodedStep& step, const JointVector& values) noexcept {
  step.count(static_cast<std::size_t>(values.size()));
  for (Eigen::Index i = 0; i < values.size(); ++i) step << values[i];
}

void add_rotation(EncodedStep& step, const Eigen::Quaterniond& rotation) noexcept {
  step << rotation.x() << rotation.y() << rotation.z() << rotation.w();
}

/// geometry_msgs/msg/Pose
void add_pose(EncodedStep& step, const Pose& pose) noexcept {
  const Eigen::Vector3d position = pose.translation();
  step << position.x() << position.y() << position.z();
  add_rotation(step, Eigen::Quaterniond(pose.linear()));
}

/// A generator may write an invalid value: the EDP refuses it after it has been reported.
constexpr char letter_of(AxisBehaviour behaviour) noexcept {
  switch (behaviour) {
    case AxisBehaviour::unguarded:
      return 'u';
    case AxisBehaviour::guarded:
      return 'g';
    case AxisBehaviour::contact:
      return 'c';
  }
  return '?';
}

/// The numbers of a pose as a target: x, y, z, then the quaternion w, x, y, z.
void add_pose_target(EncodedStep& step, const Pose& pose) noexcept {
  const Eigen::Quaterniond rotation(pose.linear());
  const Eigen::Vector3d position = pose.translation();
  step.count(7) << position.x() << position.y() << position.z() << rotation.w() << rotation.x() << rotation.y()
                << rotation.z();
}

void add_target(EncodedStep& step, const RobotCommand& command) noexcept {
  switch (command.kind) {
    case CommandKind::joint:
    case CommandKind::motor:
      return add_vector(step, command.joints);
    case CommandKind::pose:
      return add_pose_target(step, command.pose);
    case CommandKind::joint_velocity:
      return add_vector(step, command.joint_velocity);
    case CommandKind::twist:
      return add_vector(step, command.twist);
    case CommandKind::force:
      step.count(static_cast<std::size_t>(command.twist.size() + command.force.wrench.size()));
      for (const double value : command.twist) step << value;
      for (const double value : command.force.wrench) step << value;
      return;
    default:
      step.count(0);
  }
}

void add_command(EncodedStep& step, const RobotCommand& command) noexcept {
  // every change of the robot itself is one kind: neither Move nor Wait commands it
  step << static_cast<std::uint8_t>(std::min(command.kind, CommandKind::set_tool)) << command.relative
       << static_cast<std::uint8_t>(command.interpolation) << std::uint64_t{command.motion_steps}
       << std::uint64_t{command.reply_step} << std::uint64_t{command.start_tick};
  add_target(step, command);
  std::array<char, std::tuple_size_v<decltype(command.force.behaviour)>> letters{};
  std::transform(command.force.behaviour.begin(), command.force.behaviour.end(), letters.begin(), letter_of);
  step << (command.kind == CommandKind::force ? std::string_view{letters.data(), letters.size()} : "");
}

void add_error(EncodedStep& step, const ErrorReport& error) noexcept {
  step << static_cast<std::uint8_t>(error.error_class)
       << (error.error_class == ErrorClass::none ? std::string_view{} : std::string_view{describe(error.code)});
}

/// mrroc_msgs/msg/RobotState, up to its commands
void add_robot(EncodedStep& step, const std::string& name, const RobotState& state) noexcept {
  step << std::string_view{name} << std::uint64_t{state.tick} << std::uint64_t{state.macrostep_start};
  add_vector(step, state.joints);
  add_pose(step, state.pose);
  step << std::uint64_t{state.desired_tick};
  add_vector(step, state.desired_joints);
  add_pose(step, state.desired_pose);
  step << !state.at_rest() << static_cast<std::uint8_t>(state.coordination) << std::uint64_t{state.late_commands};
  if (state.wrench.isZero(0))
    step.count(0);
  else
    add_vector(step, state.wrench);
  step << state.lost;
  add_error(step, state.error);
}

bool is_polled(const std::string& sensor, const config::Deployment& deployment) noexcept {
  for (const config::SensorEntry& entry : deployment.sensors)
    if (entry.name == sensor) return entry.polled;
  return false;
}

std::uint8_t mode_of(const InstructionRecord::SensorEntry& sensor, const config::Deployment& deployment) noexcept {
  if (is_polled(sensor.name, deployment)) return SensorReading::POLLED;
  return sensor.interactive ? SensorReading::INTERACTIVE : SensorReading::PUBLISHED;
}

/// mrroc_msgs/msg/SensorReading
void add_sensor(EncodedStep& step, const InstructionRecord::SensorEntry& sensor, const mrroc::SensorReading& reading,
                const config::Deployment& deployment) noexcept {
  step << std::string_view{sensor.name} << std::uint64_t{reading.tick};
  step.count(reading.channel_count);
  for (std::uint32_t i = 0; i < reading.channel_count; ++i) step << reading.values[i];
  step << std::uint64_t{sensor.period} << mode_of(sensor, deployment) << std::uint64_t{reading.configuration}
       << std::uint64_t{sensor.configuration};
  add_error(step, reading.error);
}

/// At most `longest` characters of each name.
void add_head(EncodedStep& step, const config::Deployment& deployment, std::string_view process,
              const StepRecord& record, std::size_t longest) noexcept {
  const InstructionRecord& instruction = *record.instruction;
  const auto stamp = recording::stamp_of(record.tick, recording::nanoseconds_of(deployment.servo_period));
  step.clear();
  step << stamp.sec << stamp.nanosec << std::uint64_t{record.tick} << process << std::uint64_t{instruction.number}
       << instruction.is_move << std::string_view{instruction.name}.substr(0, longest);
  step.count(instruction.until ? 1 : 0);
  if (instruction.until) step << std::string_view{*instruction.until}.substr(0, longest);
  step << std::uint64_t{record.step} << std::uint64_t{record.held} << record.obtained;
}

void add_rest(EncodedStep& step, const config::Deployment& deployment, const StepRecord& record) noexcept {
  const InstructionRecord& instruction = *record.instruction;
  step.count(record.states.size());
  for (std::size_t i = 0; i < record.states.size(); ++i) {
    add_robot(step, instruction.robots[i], record.states[i]);
    step.count(record.last() ? 0 : 1);
    if (!record.last()) add_command(step, record.commands[i]);
    step.count(record.superior ? 1 : 0);
    if (record.superior) add_command(step, *record.superior);
  }
  step.count(record.readings.size());
  for (std::size_t i = 0; i < record.readings.size(); ++i)
    add_sensor(step, instruction.sensors[i], record.readings[i], deployment);
  step.count(record.conditions.size());
  for (std::size_t i = 0; i < record.conditions.size(); ++i)
    step << std::string_view{instruction.conditions[i]} << (record.conditions[i] != 0);
  step << static_cast<std::uint8_t>(record.ending);
  const bool skewed = record.last() && record.states.size() > 1;
  step.count(skewed ? 1 : 0);
  if (skewed) step << std::uint64_t{record.skew};
}

}  // namespace

void encode_step(EncodedStep& step, const config::Deployment& deployment, std::string_view process,
                 const StepRecord& record) noexcept {
  add_head(step, deployment, process, record, std::string_view::npos);
  add_rest(step, deployment, record);
  step << false;
  if (!step.full()) return;
  add_head(step, deployment, process, record, kShortened);
  step.count(0).count(0).count(0);  // robots, sensors, conditions
  step << std::uint8_t{0};          // ending
  step.count(0);                    // skew
  step << true;
}

}  // namespace mrroc::process
