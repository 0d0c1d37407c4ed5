// The messages of tasks, of the operator and of processes about themselves.
#include "links/wire/codec.hpp"
#include "links/wire/wire_parts.hpp"

namespace mrroc::links {

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
