// The messages of robots and sensors.
#include "links/wire/codec.hpp"
#include "links/wire/wire_parts.hpp"

namespace mrroc::links {
namespace {

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
  wire.lost = message.lost;
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
  message.lost = wire.lost;
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

}  // namespace mrroc::links
