#pragma once

// internal to src/links: includes what idlc generates

#include "links/wire/operator_messages.hpp"
#include "links/wire/process_status.hpp"
#include "links/wire/task_messages.hpp"
#include "messages.h"
#include "mrroc/robot_command.hpp"
#include "mrroc/sensor_link.hpp"
#include "mrroc/trajectory_link.hpp"

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
struct WireOf<TrajectoryPart> {
  using Type = mrroc_wire_TrajectoryPart;
  static const dds_topic_descriptor_t& descriptor() noexcept { return mrroc_wire_TrajectoryPart_desc; }
};

template <>
struct WireOf<TrajectoryReport> {
  using Type = mrroc_wire_TrajectoryReport;
  static const dds_topic_descriptor_t& descriptor() noexcept { return mrroc_wire_TrajectoryReport_desc; }
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

/// Writes the content of a message, all but its header, into `wire`. Numbers are copied bit by bit, NaN too: the
/// receiver judges values. Of joint vectors only the axes in use are touched. Any thread; does not allocate.
template <class T>
void encode(const T& message, Wire<T>& wire) noexcept;

/// Whether the wire form is a message: every enum and boolean in range, counts within bounds, text terminated. Any
/// thread.
template <class T>
bool valid(const Wire<T>& wire) noexcept;

/// Reads the content of a message from its wire form when that is valid; otherwise returns false and leaves `message`
/// unchanged. Any thread; does not allocate.
template <class T>
bool decode(const Wire<T>& wire, T& message) noexcept;

}  // namespace mrroc::links
