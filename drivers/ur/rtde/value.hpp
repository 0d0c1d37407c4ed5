#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

#include "drivers/ur/rtde/wire.hpp"

namespace mrroc::ur::rtde {

using Vector3d = std::array<double, 3>;
using Vector6d = std::array<double, 6>;
using Vector6Int32 = std::array<std::int32_t, 6>;
using Vector6Uint32 = std::array<std::uint32_t, 6>;

/// A value of a field. Its size is fixed, so copies allocate nothing.
using Value = std::variant<bool, std::uint8_t, std::uint32_t, std::uint64_t, std::int32_t, double, Vector3d, Vector6d,
                           Vector6Int32, Vector6Uint32>;

/// The type of a field, in the order of the alternatives of Value.
enum class FieldType : std::uint8_t {
  boolean,
  uint8,
  uint32,
  uint64,
  int32,
  real,
  vector3d,
  vector6d,
  vector6_int32,
  vector6_uint32
};
inline constexpr std::size_t kFieldTypes = std::variant_size_v<Value>;

/// Its name in the RTDE guide, such as "VECTOR6D".
std::string_view name_of(FieldType type) noexcept;
/// The type of this name; nothing for another name.
std::optional<FieldType> field_type(std::string_view name) noexcept;
/// Bytes of a value in a package.
std::size_t size_of(FieldType type) noexcept;

inline FieldType type_of(const Value& value) noexcept { return static_cast<FieldType>(value.index()); }
/// Zero of a type.
Value zero_of(FieldType type) noexcept;

/// Takes a value of this type. A boolean is true for every byte but 0.
Value take_value(WireReader& reader, FieldType type) noexcept;
void put_value(WireWriter& writer, const Value& value) noexcept;

}  // namespace mrroc::ur::rtde
