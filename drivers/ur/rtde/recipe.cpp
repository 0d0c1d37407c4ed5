#include "drivers/ur/rtde/recipe.hpp"

#include "drivers/ur/rtde/packet.hpp"

namespace mrroc::ur::rtde {

std::size_t Recipe::size() const noexcept {
  std::size_t size = sizeof id;
  for (const FieldType type : types) size += size_of(type);
  return size;
}

bool decode_data(const Recipe& recipe, Bytes payload, std::span<Value> values) noexcept {
  if (payload.size() != recipe.size() || values.size() != recipe.types.size()) return false;
  WireReader reader(payload);
  if (reader.take<std::uint8_t>() != recipe.id) return false;
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = take_value(reader, recipe.types[i]);
  return reader.complete();
}

std::size_t encode_data(const Recipe& recipe, std::span<const Value> values, std::span<std::uint8_t> memory) noexcept {
  const std::size_t length = kHeaderSize + recipe.size();
  if (values.size() != recipe.types.size() || length > kMaxPacket) return 0;
  WireWriter writer(memory);
  writer.put(static_cast<std::uint16_t>(length));
  writer.put(static_cast<std::uint8_t>(PacketType::data_package));
  writer.put(recipe.id);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (type_of(values[i]) != recipe.types[i]) return 0;
    put_value(writer, values[i]);
  }
  return writer.ok() ? writer.size() : 0;
}

std::vector<std::string> split_names(std::string_view list) {
  std::vector<std::string> names;
  if (list.ends_with(',')) list.remove_suffix(1);
  while (!list.empty()) {
    const std::size_t comma = list.find(',');
    names.emplace_back(list.substr(0, comma));
    if (comma == std::string_view::npos) break;
    list.remove_prefix(comma + 1);
    if (list.empty()) names.emplace_back();
  }
  return names;
}

std::string join_names(std::span<const std::string> names) {
  std::string list;
  for (const std::string& name : names) {
    if (!list.empty()) list += ',';
    list += name;
  }
  return list;
}

}  // namespace mrroc::ur::rtde
