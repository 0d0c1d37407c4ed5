#pragma once

// internal to src/links: includes what idlc generates

#include <algorithm>
#include <cstring>

#include "links/wire/task_messages.hpp"
#include "messages.h"
#include "mrroc/robot_state.hpp"

/// Common parts of several messages and their wire form: `encode_...` writes one, `valid_...` checks it, `decode_...`
/// reads a valid one. Any thread; never allocates or throws.
namespace mrroc::links {

using RowMajorFrame = Eigen::Matrix<double, 3, 4, Eigen::RowMajor>;

/// A code is known when it has a text: errors.cpp has the only list of them.
inline bool known(ErrorCode code) noexcept { return describe(code) != describe(static_cast<ErrorCode>(0xFFFF)); }

template <class Enum>
bool in_range(std::uint8_t value, Enum last) noexcept {
  return value <= static_cast<std::uint8_t>(last);
}

inline bool is_boolean(std::uint8_t value) noexcept { return value <= 1; }

template <std::size_t Size>
bool terminated(const char (&text)[Size]) noexcept {
  return std::memchr(text, '\0', Size) != nullptr;
}

template <std::size_t Capacity>
inline void encode_text(const FixedText<Capacity>& text, char (&wire)[Capacity + 1]) noexcept {
  std::memcpy(wire, text.c_str(), Capacity + 1);
}

template <class... Axes>
bool valid_axes(const Axes&... axes) noexcept {
  return ((axes.count <= static_cast<std::uint32_t>(kMaxJoints)) && ...);
}

inline void encode_axes(const JointVector& vector, mrroc_wire_Axes& wire) noexcept {
  wire.count = static_cast<std::uint32_t>(vector.size());
  for (Eigen::Index i = 0; i < vector.size(); ++i) wire.values[i] = vector[i];
}

inline void decode_axes(const mrroc_wire_Axes& wire, JointVector& vector) noexcept {
  vector.resize(static_cast<Eigen::Index>(wire.count));
  for (Eigen::Index i = 0; i < vector.size(); ++i) vector[i] = wire.values[i];
}

inline void encode_frame(const Pose& pose, double (&wire)[12]) noexcept {
  Eigen::Map<RowMajorFrame>{wire} = pose.matrix().topRows<3>();
}

inline void decode_frame(const double (&wire)[12], Pose& pose) noexcept {
  pose.matrix().topRows<3>() = Eigen::Map<const RowMajorFrame>{wire};
  pose.makeAffine();
}

inline bool valid_parcel(const mrroc_wire_Parcel& wire) noexcept {
  return terminated(wire.label) && wire.size <= Parcel::kCapacity;
}

inline void encode_parcel(const Parcel& parcel, mrroc_wire_Parcel& wire) noexcept {
  encode_text(parcel.label, wire.label);
  wire.fingerprint = parcel.fingerprint;
  wire.size = parcel.size;
  std::memcpy(wire.content, parcel.content.data(), sizeof wire.content);
}

inline void decode_parcel(const mrroc_wire_Parcel& wire, Parcel& parcel) noexcept {
  parcel.label.assign(wire.label);
  parcel.fingerprint = wire.fingerprint;
  parcel.size = wire.size;
  std::memcpy(parcel.content.data(), wire.content, sizeof wire.content);
}

inline bool valid_error(const mrroc_wire_Fault& wire) noexcept {
  return in_range(wire.error_class, ErrorClass::system) && known(static_cast<ErrorCode>(wire.code)) &&
         terminated(wire.detail);
}

inline void encode_error(const ErrorReport& error, mrroc_wire_Fault& wire) noexcept {
  wire.error_class = static_cast<std::uint8_t>(error.error_class);
  wire.code = static_cast<std::uint16_t>(error.code);
  encode_text(error.detail, wire.detail);
}

inline void decode_error(const mrroc_wire_Fault& wire, ErrorReport& error) noexcept {
  error.error_class = static_cast<ErrorClass>(wire.error_class);
  error.code = static_cast<ErrorCode>(wire.code);
  error.detail.assign(wire.detail);
}

inline void encode_signals(const Signals& signals, mrroc_wire_Terminals& wire) noexcept {
  wire.digital = signals.digital;
  std::copy(signals.analog.begin(), signals.analog.end(), wire.analog);
}

inline void decode_signals(const mrroc_wire_Terminals& wire, Signals& signals) noexcept {
  signals.digital = wire.digital;
  std::copy_n(wire.analog, signals.analog.size(), signals.analog.begin());
}

}  // namespace mrroc::links
