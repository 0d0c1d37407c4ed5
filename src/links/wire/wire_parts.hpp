#pragma once

// internal to src/links: includes what idlc generates

#include <algorithm>
#include <array>
#include <cstring>
#include <type_traits>

#include "links/wire/operator_messages.hpp"
#include "links/wire/process_status.hpp"
#include "links/wire/task_messages.hpp"
#include "messages.h"
#include "mrroc/message_field.hpp"
#include "mrroc/robot_command.hpp"
#include "mrroc/sensor_link.hpp"
#include "mrroc/trajectory_link.hpp"

/// What messages are made of, in their wire form and back: for each type of a field `put` writes the wire form,
/// `is_valid` returns whether the wire form is a value of the type (`Value<T>` names it), `get` reads a valid one. The
/// sizes of the IDL's arrays are checked against the types by the compiler. Any thread; never allocates or throws.
namespace mrroc::links {

template <class T>
using Value = std::type_identity<T>;

/// The last value of an enum that travels as an octet.
template <class Enum>
inline constexpr Enum kLast = Enum::unknown;
template <>
inline constexpr CommandKind kLast<CommandKind> = CommandKind::end;
template <>
inline constexpr Coordination kLast<Coordination> = Coordination::left;
template <>
inline constexpr Interpolation kLast<Interpolation> = Interpolation::task;
template <>
inline constexpr AxisBehaviour kLast<AxisBehaviour> = AxisBehaviour::contact;
template <>
inline constexpr SensorRequestKind kLast<SensorRequestKind> = SensorRequestKind::configure;
template <>
inline constexpr TaskCommandKind kLast<TaskCommandKind> = TaskCommandKind::speed;
template <>
inline constexpr TaskState kLast<TaskState> = TaskState::stopped;
template <>
inline constexpr QuestionKind kLast<QuestionKind> = QuestionKind::choice;
template <>
inline constexpr TrajectoryOrder kLast<TrajectoryOrder> = TrajectoryOrder::cancel;
template <>
inline constexpr TrajectoryState kLast<TrajectoryState> = TrajectoryState::taken_back;
template <>
inline constexpr ProcessRole kLast<ProcessRole> = ProcessRole::sim;
template <>
inline constexpr ProcessState kLast<ProcessState> = ProcessState::failed;
template <>
inline constexpr ErrorClass kLast<ErrorClass> = ErrorClass::system;

template <class T>
concept OctetEnum = std::is_enum_v<T> && !std::is_same_v<T, ErrorCode>;

// ---- numbers, booleans, enums

template <class T>
requires(std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) void put(T value, T& wire) noexcept { wire = value; }
template <class T>
requires(std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) bool is_valid(Value<T>, T) noexcept { return true; }
template <class T>
requires(std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) void get(T wire, T& value) noexcept { value = wire; }

inline void put(bool value, std::uint8_t& wire) noexcept { wire = value ? 1 : 0; }
inline bool is_valid(Value<bool>, std::uint8_t wire) noexcept { return wire <= 1; }
inline void get(std::uint8_t wire, bool& value) noexcept { value = wire != 0; }

template <OctetEnum T>
void put(T value, std::uint8_t& wire) noexcept {
  wire = static_cast<std::uint8_t>(value);
}
template <OctetEnum T>
bool is_valid(Value<T>, std::uint8_t wire) noexcept {
  return wire <= static_cast<std::uint8_t>(kLast<T>);
}
template <OctetEnum T>
void get(std::uint8_t wire, T& value) noexcept {
  value = static_cast<T>(wire);
}

inline void put(ErrorCode value, std::uint16_t& wire) noexcept { wire = static_cast<std::uint16_t>(value); }
/// A code is known when it has a text: errors.cpp keeps the one list of them.
inline bool is_valid(Value<ErrorCode>, std::uint16_t wire) noexcept {
  return describe(static_cast<ErrorCode>(wire)) != describe(static_cast<ErrorCode>(0xFFFF));
}
inline void get(std::uint16_t wire, ErrorCode& value) noexcept { value = static_cast<ErrorCode>(wire); }

// ---- text, arrays, vectors, poses

template <std::size_t Capacity>
void put(const FixedText<Capacity>& value, char (&wire)[Capacity + 1]) noexcept {
  std::memcpy(wire, value.c_str(), Capacity + 1);
}
template <std::size_t Capacity>
bool is_valid(Value<FixedText<Capacity>>, const char (&wire)[Capacity + 1]) noexcept {
  return std::memchr(wire, '\0', Capacity + 1) != nullptr;
}
template <std::size_t Capacity>
void get(const char (&wire)[Capacity + 1], FixedText<Capacity>& value) noexcept {
  value.assign(wire);
}

template <class T, class Wire, std::size_t Size>
void put(const std::array<T, Size>& value, Wire (&wire)[Size]) noexcept {
  for (std::size_t i = 0; i < Size; ++i) put(value[i], wire[i]);
}
template <class T, class Wire, std::size_t Size>
bool is_valid(Value<std::array<T, Size>>, const Wire (&wire)[Size]) noexcept {
  return std::all_of(wire, wire + Size, [](const Wire& each) { return is_valid(Value<T>{}, each); });
}
template <class T, class Wire, std::size_t Size>
void get(const Wire (&wire)[Size], std::array<T, Size>& value) noexcept {
  for (std::size_t i = 0; i < Size; ++i) get(wire[i], value[i]);
}

template <int Rows>
using Column = Eigen::Matrix<double, Rows, 1>;

inline void put(const Column<6>& value, double (&wire)[6]) noexcept { Eigen::Map<Column<6>>{wire} = value; }
inline bool is_valid(Value<Column<6>>, const double (&)[6]) noexcept { return true; }
inline void get(const double (&wire)[6], Column<6>& value) noexcept { value = Eigen::Map<const Column<6>>{wire}; }

inline void put(const Load& value, double (&wire)[4]) noexcept {
  wire[0] = value.mass;
  Eigen::Map<Column<3>>{wire + 1} = value.centre;
}
inline bool is_valid(Value<Load>, const double (&)[4]) noexcept { return true; }
inline void get(const double (&wire)[4], Load& value) noexcept {
  value.mass = wire[0];
  value.centre = Eigen::Map<const Column<3>>{wire + 1};
}

static_assert(std::extent_v<decltype(mrroc_wire_Axes::values)> == kMaxJoints, "messages.idl: Axes");

/// Only the axes in use are written and read.
inline void put(const JointVector& value, mrroc_wire_Axes& wire) noexcept {
  wire.count = static_cast<std::uint32_t>(value.size());
  std::copy_n(value.data(), value.size(), wire.values);
}
inline bool is_valid(Value<JointVector>, const mrroc_wire_Axes& wire) noexcept {
  return wire.count <= static_cast<std::uint32_t>(kMaxJoints);
}
inline void get(const mrroc_wire_Axes& wire, JointVector& value) noexcept {
  value.resize(static_cast<Eigen::Index>(wire.count));
  std::copy_n(wire.values, value.size(), value.data());
}

static_assert(sizeof(mrroc_wire_Frame) == FieldOf<Pose>::kSize, "messages.idl: Frame");

/// In the one order in which poses travel: that of a message's field.
inline void put(const Pose& value, double (&wire)[12]) noexcept {
  FieldOf<Pose>::put(value, reinterpret_cast<std::uint8_t*>(wire));
}
inline bool is_valid(Value<Pose>, const double (&)[12]) noexcept { return true; }
inline void get(const double (&wire)[12], Pose& value) noexcept {
  FieldOf<Pose>::get(reinterpret_cast<const std::uint8_t*>(wire), value);
}

}  // namespace mrroc::links
