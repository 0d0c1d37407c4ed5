#include "links/codec.hpp"

#include <cstring>

namespace mrroc::links {
namespace {

using RowMajorFrame = Eigen::Matrix<double, 3, 4, Eigen::RowMajor>;

/// A code is known when it has a text: errors.cpp keeps the one list of them.
bool known(ErrorCode code) noexcept { return describe(code) != describe(static_cast<ErrorCode>(0xFFFF)); }

template <class Enum>
bool in_range(std::uint8_t value, Enum last) noexcept {
  return value <= static_cast<std::uint8_t>(last);
}

bool is_boolean(std::uint8_t value) noexcept { return value <= 1; }

template <std::size_t Size>
bool terminated(const char (&text)[Size]) noexcept {
  return std::memchr(text, '\0', Size) != nullptr;
}

template <std::size_t Capacity>
void encode_text(const FixedText<Capacity>& text, char (&wire)[Capacity + 1]) noexcept {
  std::memcpy(wire, text.c_str(), Capacity + 1);
}

template <class... Axes>
bool valid_axes(const Axes&... axes) noexcept {
  return ((axes.count <= static_cast<std::uint32_t>(kMaxJoints)) && ...);
}

void encode_axes(const JointVector& vector, mrroc_wire_Axes& wire) noexcept {
  wire.count = static_cast<std::uint32_t>(vector.size());
  for (Eigen::Index i = 0; i < vector.size(); ++i) wire.values[i] = vector[i];
}

void decode_axes(const mrroc_wire_Axes& wire, JointVector& vector) noexcept {
  vector.resize(static_cast<Eigen::Index>(wire.count));
  for (Eigen::Index i = 0; i < vector.size(); ++i) vector[i] = wire.values[i];
}

void encode_frame(const Pose& pose, double (&wire)[12]) noexcept {
  Eigen::Map<RowMajorFrame>{wire} = pose.matrix().topRows<3>();
}

void decode_frame(const double (&wire)[12], Pose& pose) noexcept {
  pose.matrix().topRows<3>() = Eigen::Map<const RowMajorFrame>{wire};
  pose.makeAffine();
}

bool valid_parcel(const mrroc_wire_Parcel& wire) noexcept {
  return terminated(wire.label) && wire.size <= Parcel::kCapacity;
}

void encode_parcel(const Parcel& parcel, mrroc_wire_Parcel& wire) noexcept {
  encode_text(parcel.label, wire.label);
  wire.fingerprint = parcel.fingerprint;
  wire.size = parcel.size;
  std::memcpy(wire.content, parcel.content.data(), sizeof wire.content);
}

void decode_parcel(const mrroc_wire_Parcel& wire, Parcel& parcel) noexcept {
  parcel.label.assign(wire.label);
  parcel.fingerprint = wire.fingerprint;
  parcel.size = wire.size;
  std::memcpy(parcel.content.data(), wire.content, sizeof wire.content);
}

bool valid_error(const mrroc_wire_Fault& wire) noexcept {
  return in_range(wire.error_class, ErrorClass::system) && known(static_cast<ErrorCode>(wire.code)) &&
         terminated(wire.detail);
}

void encode_error(const ErrorReport& error, mrroc_wire_Fault& wire) noexcept {
  wire.error_class = static_cast<std::uint8_t>(error.error_class);
  wire.code = static_cast<std::uint16_t>(error.code);
  encode_text(error.detail, wire.detail);
}

void decode_error(const mrroc_wire_Fault& wire, ErrorReport& error) noexcept {
  error.error_class = static_cast<ErrorClass>(wire.error_class);
  error.code = static_cast<ErrorCode>(wire.code);
  error.detail.assign(wire.detail);
}

void encode_signals(const Signals& signals, mrroc_wire_Terminals& wire) noexcept {
  wire.digital = signals.digital;
  std::copy(signals.analog.begin(), signals.analog.end(), wire.analog);
}

void decode_signals(const mrroc_wire_Terminals& wire, Signals& signals) noexcept {
  signals.digital = wire.digital;
  std::copy_n(wire.analog, signals.analog.size(), signals.analog.begin());
}

void encode_law(const ForceLaw& law, mrroc_wire_RobotCommand& wire) noexcept {
  for (std::size_t i = 0; i < law.behaviour.size(); ++i)
    wire.force_behaviour[i] = static_cast<std::uint8_t>(law.behaviour[i]);
  Eigen::Map<Wrench>{wire.force_wrench} = law.wrench;
  Eigen::Map<ForceLaw::Axes>{wire.force_inertia} = law.inertia;
  Eigen::Map<ForceLaw::Axes>{wire.force_reciprocal_damping} = law.reciprocal_damping;
}

void decode_law(const mrroc_wire_RobotCommand& wire, ForceLaw& law) noexcept {
  for (std::size_t i = 0; i < law.behaviour.size(); ++i)
    law.behaviour[i] = static_cast<AxisBehaviour>(wire.force_behaviour[i]);
  law.wrench = Eigen::Map<const Wrench>{wire.force_wrench};
  law.inertia = Eigen::Map<const ForceLaw::Axes>{wire.force_inertia};
  law.reciprocal_damping = Eigen::Map<const ForceLaw::Axes>{wire.force_reciprocal_damping};
}

}  // namespace

void encode(const RobotCommand& message, mrroc_wire_RobotCommand& wire) noexcept {
  wire.command_kind = static_cast<std::uint8_t>(message.kind);
  wire.relative = message.relative ? 1 : 0;
  wire.interpolation = static_cast<std::uint8_t>(message.interpolation);
  wire.motion_steps = message.motion_steps;
  wire.reply_step = message.reply_step;
  wire.start_tick = message.start_tick;
  encode_axes(message.joints, wire.joints);
  encode_axes(message.joint_velocity, wire.joint_velocity);
  encode_axes(message.joint_acceleration, wire.joint_acceleration);
  encode_frame(message.pose, wire.pose);
  Eigen::Map<Twist>{wire.twist} = message.twist;
  encode_axes(message.twist_rate, wire.twist_rate);
  encode_law(message.force, wire);
  wire.choice = message.choice;
  wire.with_outputs = message.with_outputs ? 1 : 0;
  encode_signals(message.outputs, wire.outputs);
}

bool decode(const mrroc_wire_RobotCommand& wire, RobotCommand& message) noexcept {
  if (!in_range(wire.command_kind, CommandKind::set_outputs) || !is_boolean(wire.relative) ||
      !is_boolean(wire.with_outputs))
    return false;
  if (!in_range(wire.interpolation, Interpolation::task)) return false;
  if (!valid_axes(wire.joints, wire.joint_velocity, wire.joint_acceleration, wire.twist_rate)) return false;
  for (const std::uint8_t behaviour : wire.force_behaviour)
    if (!in_range(behaviour, AxisBehaviour::contact)) return false;
  message.kind = static_cast<CommandKind>(wire.command_kind);
  message.relative = wire.relative != 0;
  message.interpolation = static_cast<Interpolation>(wire.interpolation);
  message.motion_steps = wire.motion_steps;
  message.reply_step = wire.reply_step;
  message.start_tick = wire.start_tick;
  decode_axes(wire.joints, message.joints);
  decode_axes(wire.joint_velocity, message.joint_velocity);
  decode_axes(wire.joint_acceleration, message.joint_acceleration);
  decode_frame(wire.pose, message.pose);
  message.twist = Eigen::Map<const Twist>{wire.twist};
  decode_axes(wire.twist_rate, message.twist_rate);
  decode_law(wire, message.force);
  message.choice = wire.choice;
  message.with_outputs = wire.with_outputs != 0;
  decode_signals(wire.outputs, message.outputs);
  return true;
}

void encode(const RobotState& message, mrroc_wire_RobotState& wire) noexcept {
  wire.tick = message.tick;
  encode_axes(message.joints, wire.joints);
  encode_axes(message.joint_velocity, wire.joint_velocity);
  encode_axes(message.motors, wire.motors);
  encode_axes(message.current, wire.current);
  encode_frame(message.pose, wire.pose);
  wire.macrostep_start = message.macrostep_start;
  wire.desired_tick = message.desired_tick;
  encode_axes(message.desired_joints, wire.desired_joints);
  encode_axes(message.desired_velocity, wire.desired_velocity);
  encode_axes(message.desired_acceleration, wire.desired_acceleration);
  encode_frame(message.desired_pose, wire.desired_pose);
  wire.model = message.model;
  encode_frame(message.tool, wire.tool);
  Eigen::Map<Wrench>{wire.wrench} = message.wrench;
  encode_signals(message.inputs, wire.inputs);
  encode_signals(message.outputs, wire.outputs);
  wire.regulators = message.regulators;
  wire.synchronised = message.synchronised ? 1 : 0;
  wire.enabled = message.enabled ? 1 : 0;
  wire.late_commands = message.late_commands;
  encode_error(message.error, wire.error);
}

bool decode(const mrroc_wire_RobotState& wire, RobotState& message) noexcept {
  if (!is_boolean(wire.synchronised) || !is_boolean(wire.enabled) || !valid_error(wire.error)) return false;
  if (!valid_axes(wire.joints, wire.joint_velocity, wire.motors, wire.current)) return false;
  if (!valid_axes(wire.desired_joints, wire.desired_velocity, wire.desired_acceleration)) return false;
  message.tick = wire.tick;
  decode_axes(wire.joints, message.joints);
  decode_axes(wire.joint_velocity, message.joint_velocity);
  decode_axes(wire.motors, message.motors);
  decode_axes(wire.current, message.current);
  decode_frame(wire.pose, message.pose);
  message.macrostep_start = wire.macrostep_start;
  message.desired_tick = wire.desired_tick;
  decode_axes(wire.desired_joints, message.desired_joints);
  decode_axes(wire.desired_velocity, message.desired_velocity);
  decode_axes(wire.desired_acceleration, message.desired_acceleration);
  decode_frame(wire.desired_pose, message.desired_pose);
  message.model = wire.model;
  decode_frame(wire.tool, message.tool);
  message.wrench = Eigen::Map<const Wrench>{wire.wrench};
  decode_signals(wire.inputs, message.inputs);
  decode_signals(wire.outputs, message.outputs);
  message.regulators = wire.regulators;
  message.synchronised = wire.synchronised != 0;
  message.enabled = wire.enabled != 0;
  message.late_commands = wire.late_commands;
  decode_error(wire.error, message.error);
  return true;
}

void encode(const SensorRequest& message, mrroc_wire_SensorRequest& wire) noexcept {
  wire.request_kind = static_cast<std::uint8_t>(message.kind);
  wire.measure_at = message.measure_at;
}

bool decode(const mrroc_wire_SensorRequest& wire, SensorRequest& message) noexcept {
  if (!in_range(wire.request_kind, SensorRequestKind::bias)) return false;
  message.kind = static_cast<SensorRequestKind>(wire.request_kind);
  message.measure_at = wire.measure_at;
  return true;
}

void encode(const SensorReading& message, mrroc_wire_SensorReading& wire) noexcept {
  wire.number = message.sequence;
  wire.tick = message.tick;
  wire.channel_count = message.channel_count;
  std::memcpy(wire.values, message.values.data(), sizeof wire.values);
  encode_error(message.error, wire.error);
}

bool decode(const mrroc_wire_SensorReading& wire, SensorReading& message) noexcept {
  if (wire.channel_count > kMaxChannels || !valid_error(wire.error)) return false;
  message.sequence = wire.number;
  message.tick = wire.tick;
  message.channel_count = wire.channel_count;
  std::memcpy(message.values.data(), wire.values, sizeof wire.values);
  decode_error(wire.error, message.error);
  return true;
}

void encode(const TaskCommand& message, mrroc_wire_TaskCommand& wire) noexcept {
  wire.command_kind = static_cast<std::uint8_t>(message.kind);
  encode_parcel(message.parcel, wire.parcel);
}

bool decode(const mrroc_wire_TaskCommand& wire, TaskCommand& message) noexcept {
  if (!in_range(wire.command_kind, TaskCommandKind::message) || !valid_parcel(wire.parcel)) return false;
  decode_parcel(wire.parcel, message.parcel);
  message.kind = static_cast<TaskCommandKind>(wire.command_kind);
  return true;
}

void encode(const TaskStatus& message, mrroc_wire_TaskStatus& wire) noexcept {
  wire.state = static_cast<std::uint8_t>(message.state);
  encode_error(message.error, wire.error);
  encode_text(message.process, wire.process);
  encode_text(message.device, wire.device);
  wire.step = message.step;
  wire.error_tick = message.error_tick;
  wire.tick = message.tick;
  encode_parcel(message.parcel, wire.parcel);
}

bool decode(const mrroc_wire_TaskStatus& wire, TaskStatus& message) noexcept {
  if (!in_range(wire.state, TaskState::stopped) || !valid_error(wire.error)) return false;
  if (!terminated(wire.process) || !terminated(wire.device) || !valid_parcel(wire.parcel)) return false;
  decode_parcel(wire.parcel, message.parcel);
  message.state = static_cast<TaskState>(wire.state);
  decode_error(wire.error, message.error);
  message.process.assign(wire.process);
  message.device.assign(wire.device);
  message.step = wire.step;
  message.error_tick = wire.error_tick;
  message.tick = wire.tick;
  return true;
}

void encode(const OperatorQuestion& message, mrroc_wire_OperatorQuestion& wire) noexcept {
  encode_text(message.text, wire.text);
  wire.question_kind = static_cast<std::uint8_t>(message.kind);
  wire.minimum = message.minimum;
  wire.maximum = message.maximum;
  wire.choice_count = message.choice_count;
  for (std::size_t i = 0; i < message.choices.size(); ++i) encode_text(message.choices[i], wire.choices[i]);
  wire.tick = message.tick;
}

bool decode(const mrroc_wire_OperatorQuestion& wire, OperatorQuestion& message) noexcept {
  if (!terminated(wire.text) || !in_range(wire.question_kind, QuestionKind::choice)) return false;
  if (wire.choice_count > message.choices.size()) return false;
  for (const auto& choice : wire.choices)
    if (!terminated(choice)) return false;
  message.text.assign(wire.text);
  message.kind = static_cast<QuestionKind>(wire.question_kind);
  message.minimum = wire.minimum;
  message.maximum = wire.maximum;
  message.choice_count = wire.choice_count;
  for (std::size_t i = 0; i < message.choices.size(); ++i) message.choices[i].assign(wire.choices[i]);
  message.tick = wire.tick;
  return true;
}

void encode(const OperatorAnswer& message, mrroc_wire_OperatorAnswer& wire) noexcept {
  wire.question = message.question;
  wire.value = message.value;
}

bool decode(const mrroc_wire_OperatorAnswer& wire, OperatorAnswer& message) noexcept {
  message.question = wire.question;
  message.value = wire.value;
  return true;
}

void encode(const ProcessStatus& message, mrroc_wire_ProcessStatus& wire) noexcept {
  encode_text(message.process, wire.process);
  wire.process_role = static_cast<std::uint8_t>(message.role);
  wire.process_state = static_cast<std::uint8_t>(message.state);
  wire.boot = message.boot;
  wire.beat = message.beat;
  wire.pid = message.pid;
  wire.tick = message.tick;
  wire.instruction = message.instruction;
  encode_text(message.activity, wire.activity);
  wire.step = message.step;
  encode_error(message.error, wire.error);
  const Counters& counters = message.counters;
  wire.counts = {
      counters.ticks,         counters.missed_ticks,     counters.late_commands,    counters.stale_replies,
      counters.common_steps,  counters.skew_ticks,       counters.wakeup_p50_us,    counters.wakeup_p99_us,
      counters.wakeup_max_us, counters.execution_p50_us, counters.execution_p99_us, counters.execution_max_us};
}

bool decode(const mrroc_wire_ProcessStatus& wire, ProcessStatus& message) noexcept {
  if (!terminated(wire.process) || !terminated(wire.activity) || !valid_error(wire.error)) return false;
  if (!in_range(wire.process_role, ProcessRole::sim) || !in_range(wire.process_state, ProcessState::failed)) {
    return false;
  }
  message.process.assign(wire.process);
  message.role = static_cast<ProcessRole>(wire.process_role);
  message.state = static_cast<ProcessState>(wire.process_state);
  message.boot = wire.boot;
  message.beat = wire.beat;
  message.pid = wire.pid;
  message.tick = wire.tick;
  message.instruction = wire.instruction;
  message.activity.assign(wire.activity);
  message.step = wire.step;
  decode_error(wire.error, message.error);
  const mrroc_wire_Counters& counts = wire.counts;
  message.counters = {counts.ticks,         counts.missed_ticks,     counts.late_commands,    counts.stale_replies,
                      counts.common_steps,  counts.skew_ticks,       counts.wakeup_p50_us,    counts.wakeup_p99_us,
                      counts.wakeup_max_us, counts.execution_p50_us, counts.execution_p99_us, counts.execution_max_us};
  return true;
}

}  // namespace mrroc::links
