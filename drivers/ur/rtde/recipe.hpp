#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/ur/rtde/value.hpp"

namespace mrroc::ur::rtde {

/// The fields of a data package in their order, as controller and client have agreed. The identifier precedes them in
/// each package.
struct Recipe {
  std::uint8_t id = 0;
  std::vector<FieldType> types;

  /// Bytes of the payload of a data package.
  std::size_t size() const noexcept;
};

/// Reads the payload of a data package into `values`, which has an element for each field. False, and `values` may be
/// partly written: the identifier or the length is another one. Allocates nothing, never throws.
bool decode_data(const Recipe& recipe, Bytes payload, std::span<Value> values) noexcept;

/// Writes a whole data package, header included, into `memory`. Returns its size, or 0: `memory` is too small, or
/// `values` are not of the recipe's types. Allocates nothing, never throws.
std::size_t encode_data(const Recipe& recipe, std::span<const Value> values, std::span<std::uint8_t> memory) noexcept;

/// Splits "a,b,c", and also "a,b,c,", at its commas.
std::vector<std::string> split_names(std::string_view list);
std::string join_names(std::span<const std::string> names);

}  // namespace mrroc::ur::rtde
