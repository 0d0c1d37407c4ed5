#include "drivers/ur/rtde/value.hpp"

namespace mrroc::ur::rtde {
namespace {

struct TypeEntry {
  std::string_view name;
  std::size_t size;
};

constexpr std::array<TypeEntry, kFieldTypes> kTypes{{{"BOOL", 1},
                                                     {"UINT8", 1},
                                                     {"UINT32", 4},
                                                     {"UINT64", 8},
                                                     {"INT32", 4},
                                                     {"DOUBLE", 8},
                                                     {"VECTOR3D", 24},
                                                     {"VECTOR6D", 48},
                                                     {"VECTOR6INT32", 24},
                                                     {"VECTOR6UINT32", 24}}};

const TypeEntry& entry_of(FieldType type) noexcept { return kTypes[static_cast<std::size_t>(type)]; }

template <class T, std::size_t N>
Value take_array(WireReader& reader) noexcept {
  std::array<T, N> values{};
  for (T& value : values) value = reader.take<T>();
  return values;
}

struct PutValue {
  WireWriter& writer;
  void operator()(bool value) const noexcept { writer.put(static_cast<std::uint8_t>(value)); }
  template <class T>
  void operator()(T value) const noexcept {
    writer.put(value);
  }
  template <class T, std::size_t N>
  void operator()(const std::array<T, N>& values) const noexcept {
    for (const T value : values) writer.put(value);
  }
};

}  // namespace

std::string_view name_of(FieldType type) noexcept { return entry_of(type).name; }
std::size_t size_of(FieldType type) noexcept { return entry_of(type).size; }

std::optional<FieldType> field_type(std::string_view name) noexcept {
  for (std::size_t i = 0; i < kFieldTypes; ++i)
    if (kTypes[i].name == name) return static_cast<FieldType>(i);
  return std::nullopt;
}

Value zero_of(FieldType type) noexcept {
  const std::array<std::uint8_t, 48> zeros{};
  WireReader reader(zeros);
  return take_value(reader, type);
}

Value take_value(WireReader& reader, FieldType type) noexcept {
  switch (type) {
    case FieldType::boolean:
      return reader.take<std::uint8_t>() != 0;
    case FieldType::uint8:
      return reader.take<std::uint8_t>();
    case FieldType::uint32:
      return reader.take<std::uint32_t>();
    case FieldType::uint64:
      return reader.take<std::uint64_t>();
    case FieldType::int32:
      return reader.take<std::int32_t>();
    case FieldType::real:
      return reader.take<double>();
    case FieldType::vector3d:
      return take_array<double, 3>(reader);
    case FieldType::vector6d:
      return take_array<double, 6>(reader);
    case FieldType::vector6_int32:
      return take_array<std::int32_t, 6>(reader);
    case FieldType::vector6_uint32:
      return take_array<std::uint32_t, 6>(reader);
  }
  return false;
}

void put_value(WireWriter& writer, const Value& value) noexcept { std::visit(PutValue{writer}, value); }

}  // namespace mrroc::ur::rtde
