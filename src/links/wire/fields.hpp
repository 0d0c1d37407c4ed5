#pragma once

// internal to src/links: includes what idlc generates

#include "links/wire/wire_parts.hpp"

/// The one description of each message: its fields, and where each is in the wire form. `field(value, wire)` is called
/// for each of them in order until it returns false; `count(value, wire, most)` for a number with an upper bound of its
/// own. `M` and `Wire` may be const. A new field is a line here and a line in messages.idl.
namespace mrroc::links {

template <class M, class Type>
concept Is = std::is_same_v<std::remove_const_t<M>, Type>;

template <Is<ErrorReport> M, class Wire, class Visitor>
bool visit_fields(M& m, Wire& w, const Visitor& v) noexcept {
  return v.field(m.error_class, w.error_class) && v.field(m.code, w.code) && v.field(m.detail, w.detail);
}

template <Is<ControllerIo> M, class Wire, class Visitor>
bool visit_fields(M& m, Wire& w, const Visitor& v) noexcept {
  return v.field(m.digital, w.digital) && v.field(m.analog, w.analog);
}

template <Is<Message> M, class Wire, class Visitor>
bool visit_fields(M& m, Wire& w, const Visitor& v) noexcept {
  return v.field(m.label, w.label) && v.field(m.fingerprint, w.fingerprint) &&
         v.count(m.size, w.size, Message::kCapacity) && v.field(m.content, w.content);
}

template <Is<ForceLaw> M, class Wire, class Visitor>
bool visit_fields(M& m, Wire& w, const Visitor& v) noexcept {
  return v.field(m.behaviour, w.behaviour) && v.field(m.wrench, w.wrench) && v.field(m.inertia, w.inertia) &&
         v.field(m.admittance, w.admittance);
}

template <Is<Counters> M, class Wire, class Visitor>
bool visit_fields(M& m, Wire& w, const Visitor& v) noexcept {
  return v.field(m.ticks, w.ticks) && v.field(m.missed_ticks, w.missed_ticks) &&
         v.field(m.late_commands, w.late_commands) && v.field(m.stale_replies, w.stale_replies) &&
         v.field(m.common_steps, w.common_steps) && v.field(m.skew_ticks, w.skew_ticks) &&
         v.field(m.packages, w.packages) && v.field(m.packages_lost, w.packages_lost) &&
         v.field(m.packages_doubled, w.packages_doubled) && v.field(m.packages_late, w.packages_late) &&
         v.field(m.packages_bunched, w.packages_bunched) && v.field(m.wakeup_p50_us, w.wakeup_p50_us) &&
         v.field(m.wakeup_p99_us, w.wakeup_p99_us) && v.field(m.wakeup_max_us, w.wakeup_max_us) &&
         v.field(m.execution_p50_us, w.execution_p50_us) && v.field(m.execution_p99_us, w.execution_p99_us) &&
         v.field(m.execution_max_us, w.execution_max_us);
}

template <Is<RobotCommand> M, class Wire, class Visitor>
bool visit_fields(M& m, Wire& w, const Visitor& v) noexcept {
  return v.field(m.kind, w.command_kind) && v.field(m.relative, w.relative) &&
         v.field(m.interpolation, w.interpolation) && v.field(m.motion_steps, w.motion_steps) &&
         v.field(m.reply_step, w.reply_step) && v.field(m.start_tick, w.start_tick) && v.field(m.joints, w.joints) &&
         v.field(m.joint_velocity, w.joint_velocity) && v.field(m.joint_acceleration, w.joint_acceleration) &&
         v.field(m.pose, w.pose) && v.field(m.twist, w.twist) && v.field(m.twist_acceleration, w.twist_acceleration) &&
         v.field(m.force, w.force) && v.field(m.stop.ticks, w.stop_ticks) && v.field(m.stop.rate, w.stop_rate) &&
         v.field(m.stop.group, w.stop_group) && v.field(m.load, w.load) && v.field(m.choice, w.choice) &&
         v.field(m.with_outputs, w.with_outputs) && v.field(m.outputs, w.outputs);
}

template <Is<RobotState> M, class Wire, class Visitor>
bool visit_fields(M& m, Wire& w, const Visitor& v) noexcept {
  return v.field(m.tick, w.tick) && v.field(m.joints, w.joints) && v.field(m.joint_velocity, w.joint_velocity) &&
         v.field(m.motors, w.motors) && v.field(m.current, w.current) && v.field(m.pose, w.pose) &&
         v.field(m.macrostep_start, w.macrostep_start) && v.field(m.desired_tick, w.desired_tick) &&
         v.field(m.desired_joints, w.desired_joints) && v.field(m.desired_velocity, w.desired_velocity) &&
         v.field(m.desired_acceleration, w.desired_acceleration) && v.field(m.desired_pose, w.desired_pose) &&
         v.field(m.model, w.model) && v.field(m.tool, w.tool) && v.field(m.wrench, w.wrench) &&
         v.field(m.lost, w.lost) && v.field(m.inputs, w.inputs) && v.field(m.outputs, w.outputs) &&
         v.field(m.regulators, w.regulators) && v.field(m.synchronised, w.synchronised) &&
         v.field(m.enabled, w.enabled) && v.field(m.coordination, w.coordination) &&
         v.field(m.late_commands, w.late_commands) && v.field(m.error, w.error);
}

template <Is<SensorRequest> M, class Wire, class Visitor>
bool visit_fields(M& m, Wire& w, const Visitor& v) noexcept {
  return v.field(m.kind, w.request_kind) && v.field(m.measure_at, w.measure_at) &&
         v.field(m.configuration, w.configuration);
}

template <Is<SensorReading> M, class Wire, class Visitor>
bool visit_fields(M& m, Wire& w, const Visitor& v) noexcept {
  return v.field(m.sequence, w.number) && v.field(m.tick, w.tick) && v.field(m.configuration, w.configuration) &&
         v.count(m.channel_count, w.channel_count, kMaxChannels) && v.field(m.values, w.values) &&
         v.field(m.error, w.error);
}

template <Is<TaskCommand> M, class Wire, class Visitor>
bool visit_fields(M& m, Wire& w, const Visitor& v) noexcept {
  return v.field(m.kind, w.command_kind) && v.field(m.parcel, w.parcel) && v.field(m.speed, w.speed);
}

template <Is<TaskStatus> M, class Wire, class Visitor>
bool visit_fields(M& m, Wire& w, const Visitor& v) noexcept {
  return v.field(m.state, w.state) && v.field(m.error, w.error) && v.field(m.process, w.process) &&
         v.field(m.device, w.device) && v.field(m.step, w.step) && v.field(m.error_tick, w.error_tick) &&
         v.field(m.tick, w.tick) && v.field(m.parcel, w.parcel);
}

template <Is<OperatorQuestion> M, class Wire, class Visitor>
bool visit_fields(M& m, Wire& w, const Visitor& v) noexcept {
  return v.field(m.text, w.text) && v.field(m.kind, w.question_kind) && v.field(m.minimum, w.minimum) &&
         v.field(m.maximum, w.maximum) && v.count(m.choice_count, w.choice_count, OperatorQuestion::kChoices) &&
         v.field(m.choices, w.choices) && v.field(m.tick, w.tick);
}

template <Is<OperatorAnswer> M, class Wire, class Visitor>
bool visit_fields(M& m, Wire& w, const Visitor& v) noexcept {
  return v.field(m.question, w.question) && v.field(m.value, w.value);
}

template <Is<TrajectoryPart> M, class Wire, class Visitor>
bool visit_fields(M& m, Wire& w, const Visitor& v) noexcept {
  return v.field(m.robot, w.robot) && v.field(m.order, w.trajectory_order) && v.field(m.trajectory, w.trajectory) &&
         v.field(m.size, w.size) && v.field(m.begin, w.begin) && v.count(m.count, w.count, TrajectoryPart::kNumbers) &&
         v.field(m.numbers, w.numbers);
}

template <Is<TrajectoryReport> M, class Wire, class Visitor>
bool visit_fields(M& m, Wire& w, const Visitor& v) noexcept {
  return v.field(m.robot, w.robot) && v.field(m.trajectory, w.trajectory) && v.field(m.state, w.trajectory_state) &&
         v.field(m.text, w.text) && v.field(m.tick, w.tick);
}

template <Is<ProcessStatus> M, class Wire, class Visitor>
bool visit_fields(M& m, Wire& w, const Visitor& v) noexcept {
  return v.field(m.process, w.process) && v.field(m.role, w.process_role) && v.field(m.state, w.process_state) &&
         v.field(m.boot, w.boot) && v.field(m.beat, w.beat) && v.field(m.pid, w.pid) && v.field(m.tick, w.tick) &&
         v.field(m.instruction, w.instruction) && v.field(m.activity, w.activity) && v.field(m.step, w.step) &&
         v.field(m.error, w.error) && v.field(m.counters, w.counts);
}

}  // namespace mrroc::links
