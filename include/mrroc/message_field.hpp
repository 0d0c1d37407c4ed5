#pragma once

#include <algorithm>
#include <concepts>
#include <cstring>

#include "mrroc/fixed_text.hpp"
#include "mrroc/types.hpp"

namespace mrroc {

/// The kind of value in a field of a message, independent of its C++ type.
enum class FieldKind : std::uint8_t {
  number,   ///< double, float
  integer,  ///< any integer, sent as 64 bit
  truth,    ///< bool
  text,     ///< FixedText
  vector,   ///< an Eigen column of a fixed number of doubles
  joints,   ///< JointVector
  pose      ///< Pose
};

/// "a number", "a text", ...: for errors and listings.
const char* describe(FieldKind kind) noexcept;

/// Serialisation of a field of type T: its kind, its size in bytes, `put` and `get`. Numbers keep their bits; both
/// machines must have the same byte order. Neither function allocates.
template <class T>
struct FieldOf;

template <class T>
concept MessageField = requires {
  FieldOf<T>::kKind;
};

namespace detail {

/// A field that is sent as one value of type Carried.
template <class T, class Carried, FieldKind Kind>
struct PlainField {
  static constexpr FieldKind kKind = Kind;
  static constexpr std::size_t kSize = sizeof(Carried);
  static void put(const T& value, std::uint8_t* bytes) noexcept {
    const auto carried = static_cast<Carried>(value);
    std::memcpy(bytes, &carried, kSize);
  }
  static void get(const std::uint8_t* bytes, T& value) noexcept {
    Carried carried;
    std::memcpy(&carried, bytes, kSize);
    value = static_cast<T>(carried);
  }
};

}  // namespace detail

template <std::floating_point T>
struct FieldOf<T> : detail::PlainField<T, double, FieldKind::number> {};
template <std::integral T>
struct FieldOf<T> : detail::PlainField<T, std::int64_t, FieldKind::integer> {};
template <>
struct FieldOf<bool> : detail::PlainField<bool, std::uint8_t, FieldKind::truth> {};

template <std::size_t Capacity>
struct FieldOf<FixedText<Capacity>> {
  static constexpr FieldKind kKind = FieldKind::text;
  static constexpr std::size_t kSize = Capacity + 1;
  static void put(const FixedText<Capacity>& value, std::uint8_t* bytes) noexcept {
    std::memcpy(bytes, value.c_str(), kSize);
  }
  static void get(const std::uint8_t* bytes, FixedText<Capacity>& value) noexcept {
    const auto* text = reinterpret_cast<const char*>(bytes);
    value.assign({text, strnlen(text, Capacity)});
  }
};

template <int Rows>
requires(Rows > 0) struct FieldOf<Eigen::Matrix<double, Rows, 1>> {
  static constexpr FieldKind kKind = FieldKind::vector;
  static constexpr std::size_t kSize = Rows * sizeof(double);
  static void put(const Eigen::Matrix<double, Rows, 1>& value, std::uint8_t* bytes) noexcept {
    std::memcpy(bytes, value.data(), kSize);
  }
  static void get(const std::uint8_t* bytes, Eigen::Matrix<double, Rows, 1>& value) noexcept {
    std::memcpy(value.data(), bytes, kSize);
  }
};

template <>
struct FieldOf<JointVector> {
  static constexpr FieldKind kKind = FieldKind::joints;
  static constexpr std::size_t kSize = 1 + kMaxJoints * sizeof(double);
  static void put(const JointVector& value, std::uint8_t* bytes) noexcept {
    bytes[0] = static_cast<std::uint8_t>(value.size());
    std::memcpy(bytes + 1, value.data(), static_cast<std::size_t>(value.size()) * sizeof(double));
  }
  static void get(const std::uint8_t* bytes, JointVector& value) noexcept {
    value.resize(std::min<int>(bytes[0], kMaxJoints));
    std::memcpy(value.data(), bytes + 1, static_cast<std::size_t>(value.size()) * sizeof(double));
  }
};

template <>
struct FieldOf<Pose> {
  static constexpr FieldKind kKind = FieldKind::pose;
  static constexpr std::size_t kSize = 12 * sizeof(double);
  static void put(const Pose& value, std::uint8_t* bytes) noexcept {
    const Eigen::Matrix<double, 3, 4> rows = value.affine();
    std::memcpy(bytes, rows.data(), kSize);
  }
  static void get(const std::uint8_t* bytes, Pose& value) noexcept {
    Eigen::Matrix<double, 3, 4> rows;
    std::memcpy(rows.data(), bytes, kSize);
    value = Pose::Identity();
    value.affine() = rows;
  }
};

}  // namespace mrroc
