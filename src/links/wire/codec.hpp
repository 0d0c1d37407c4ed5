#pragma once

// internal to src/links: includes what idlc generates

#include "links/wire/operator_messages.hpp"
#include "links/wire/process_status.hpp"
#include "links/wire/task_messages.hpp"
#include "messages.h"
#include "mrroc/robot_command.hpp"
#include "mrroc/sensor_link.hpp"

namespace mrroc::links {

/// The wire form of message T: its struct and its DDS type.
template <class T>
struct WireOf;

template <>
struct WireOf<RobotCommand> {
  using Type = mrroc_wire_RobotCommand;
  static const dds_topic_descriptor_t& descriptor() noexcept { return mrroc_wire_RobotCommand_desc; }
};
template <>
struct WireOf<RobotState> {
  using Type = mrroc_wire_RobotState;
  static const dds_topic_descriptor_t& descriptor() noexcept { return mrroc_wire_RobotState_desc; }
};
template <>
struct WireOf<SensorRequest> {
  using Type = mrroc_wire_SensorRequest;
  static const dds_topic_descriptor_t& descriptor() noexcept { return mrroc_wire_SensorRequest_desc; }
};
template <>
struct WireOf<SensorReading> {
  using Type = mrroc_wire_SensorReading;
  static const dds_topic_descriptor_t& descriptor() noexcept { return mrroc_wire_SensorReading_desc; }
};
template <>
struct WireOf<TaskCommand> {
  using Type = mrroc_wire_TaskCommand;
  static const dds_topic_descriptor_t& descriptor() noexcept { return mrroc_wire_TaskCommand_desc; }
};
template <>
struct WireOf<TaskStatus> {
  using Type = mrroc_wire_TaskStatus;
  static const dds_topic_descriptor_t& descriptor() noexcept { return mrroc_wire_TaskStatus_desc; }
};
template <>
struct WireOf<OperatorQuestion> {
  using Type = mrroc_wire_OperatorQuestion;
  static const dds_topic_descriptor_t& descriptor() noexcept { return mrroc_wire_OperatorQuestion_desc; }
};
template <>
struct WireOf<OperatorAnswer> {
  using Type = mrroc_wire_OperatorAnswer;
  static const dds_topic_descriptor_t& descriptor() noexcept { return mrroc_wire_OperatorAnswer_desc; }
};
template <>
struct WireOf<ProcessStatus> {
  using Type = mrroc_wire_ProcessStatus;
  static const dds_topic_descriptor_t& descriptor() noexcept { return mrroc_wire_ProcessStatus_desc; }
};

template <class T>
using Wire = typename WireOf<T>::Type;

/// Header kinds. A ping requests a pong from the responder's process: the proof that both directions are connected.
inline constexpr std::uint32_t kData = 0;
inline constexpr std::uint32_t kPing = 1;
inline constexpr std::uint32_t kPong = 2;

// encode writes the content of a message, all but its header, into `wire`. decode does the reverse when the wire form
// is valid: every enum and boolean in range, counts within bounds, text terminated; otherwise it returns false and
// leaves `message` unchanged. Numbers are copied bit by bit, NaN too: the receiver checks their values. Of joint
// vectors only the axes in use are copied. No allocation.

void encode(const RobotCommand& message, mrroc_wire_RobotCommand& wire) noexcept;
void encode(const RobotState& message, mrroc_wire_RobotState& wire) noexcept;
void encode(const SensorRequest& message, mrroc_wire_SensorRequest& wire) noexcept;
void encode(const SensorReading& message, mrroc_wire_SensorReading& wire) noexcept;
void encode(const TaskCommand& message, mrroc_wire_TaskCommand& wire) noexcept;
void encode(const TaskStatus& message, mrroc_wire_TaskStatus& wire) noexcept;
void encode(const OperatorQuestion& message, mrroc_wire_OperatorQuestion& wire) noexcept;
void encode(const OperatorAnswer& message, mrroc_wire_OperatorAnswer& wire) noexcept;
void encode(const ProcessStatus& message, mrroc_wire_ProcessStatus& wire) noexcept;

bool decode(const mrroc_wire_RobotCommand& wire, RobotCommand& message) noexcept;
bool decode(const mrroc_wire_RobotState& wire, RobotState& message) noexcept;
bool decode(const mrroc_wire_SensorRequest& wire, SensorRequest& message) noexcept;
bool decode(const mrroc_wire_SensorReading& wire, SensorReading& message) noexcept;
bool decode(const mrroc_wire_TaskCommand& wire, TaskCommand& message) noexcept;
bool decode(const mrroc_wire_TaskStatus& wire, TaskStatus& message) noexcept;
bool decode(const mrroc_wire_OperatorQuestion& wire, OperatorQuestion& message) noexcept;
bool decode(const mrroc_wire_OperatorAnswer& wire, OperatorAnswer& message) noexcept;
bool decode(const mrroc_wire_ProcessStatus& wire, ProcessStatus& message) noexcept;

}  // namespace mrroc::links
