#include "canopen/object_value.hpp"

#include <cstdio>
#include <limits>

#include "can/frame.hpp"

namespace mrroc::canopen {

std::size_t size_of(DataType type) noexcept {
  switch (type) {
    case DataType::boolean:
    case DataType::integer8:
    case DataType::unsigned8:
      return 1;
    case DataType::integer16:
    case DataType::unsigned16:
      return 2;
    case DataType::integer32:
    case DataType::unsigned32:
    case DataType::real32:
      return 4;
    case DataType::integer64:
    case DataType::unsigned64:
      return 8;
    case DataType::visible_string:
    case DataType::octet_string:
    case DataType::domain:
      break;
  }
  return 0;
}

bool is_signed(DataType type) noexcept {
  return type == DataType::integer8 || type == DataType::integer16 || type == DataType::integer32 ||
         type == DataType::integer64;
}

std::int64_t least(DataType type) noexcept {
  return is_signed(type) ? std::numeric_limits<std::int64_t>::min() >> (64 - 8 * size_of(type)) : 0;
}

std::int64_t greatest(DataType type) noexcept {
  if (type == DataType::boolean) return 1;
  const std::size_t size = size_of(type);
  if (size == 0 || type == DataType::real32) return 0;
  const auto bits = static_cast<unsigned>(8 * size - (is_signed(type) || size == 8 ? 1 : 0));
  return static_cast<std::int64_t>((std::uint64_t{1} << bits) - 1);
}

std::string to_text(Object object) {
  char text[16];
  std::snprintf(text, sizeof text, "%04Xh:%u", object.index, object.sub);
  return text;
}

std::string to_text(std::span<const std::uint8_t> value, DataType type) {
  std::string text;
  if (type == DataType::visible_string) {
    text = '"';
    for (const std::uint8_t byte : value) text += byte >= 0x20 && byte < 0x7f ? static_cast<char>(byte) : '?';
    return text += '"';
  }
  const std::size_t size = size_of(type);
  if (size != 0 && size == value.size() && type != DataType::real32) {
    const std::uint64_t number = can::get(value, 0, size);
    return is_signed(type) ? std::to_string(can::sign_extended(number, size)) : std::to_string(number);
  }
  for (const std::uint8_t byte : value) {
    char digits[4];
    std::snprintf(digits, sizeof digits, text.empty() ? "%02x" : " %02x", byte);
    text += digits;
  }
  return text;
}

}  // namespace mrroc::canopen
