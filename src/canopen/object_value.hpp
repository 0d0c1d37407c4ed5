#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "canopen/objects.hpp"

namespace mrroc::canopen {

/// Types of values by their number in the dictionary (CiA 301, 7.4.7.1); of the others only the number is defined here.
enum class DataType : std::uint16_t {
  boolean = 0x01,
  integer8 = 0x02,
  integer16 = 0x03,
  integer32 = 0x04,
  unsigned8 = 0x05,
  unsigned16 = 0x06,
  unsigned32 = 0x07,
  real32 = 0x08,
  visible_string = 0x09,
  octet_string = 0x0a,
  domain = 0x0f,
  integer64 = 0x15,
  unsigned64 = 0x1b
};

/// Bytes of a value of a type; 0: a string, or an unknown type.
std::size_t size_of(DataType type) noexcept;
bool is_signed(DataType type) noexcept;
/// The smallest and the largest whole number of a type; both 0 for a type without whole numbers.
std::int64_t least(DataType type) noexcept;
std::int64_t greatest(DataType type) noexcept;

/// "6041h:0".
std::string to_text(Object object);

/// A value in readable form: a number, or the string in quotes; bytes in hexadecimal for an unknown type.
std::string to_text(std::span<const std::uint8_t> value, DataType type);

}  // namespace mrroc::canopen
