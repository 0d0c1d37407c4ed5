#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "canopen/eds_file.hpp"
#include "canopen/identifiers.hpp"

/// Values of objects in an EDS or DCF file (CiA 306-1, 4.6.3). A whole number is decimal, hexadecimal behind 0x or
/// octal behind a leading 0, has an optional sign, and may be a sum or difference that contains $NODEID, in any case
/// and with blanks around the signs: "384", "0x180", "-5", "$NODEID+0x180", "0x180 + $NodeId". A number is accepted
/// when its bits fit the type: 0xFFFF is -1 of an INTEGER16. A BOOLEAN may also be "true" or "false". A REAL32 is a
/// decimal number.
namespace mrroc::canopen {

/// The expected form of a value of `type`, for an error message. Empty when `text` is valid or empty, or the type has
/// no numbers.
std::string expected_value(std::string_view text, DataType type);

/// The whole number in the DefaultValue of an object of `node`, within the limits of its type. Nothing: it is missing,
/// or the type has no whole numbers. Throws std::invalid_argument for an invalid text; EdsFile has none.
std::optional<std::int64_t> default_number(const ObjectEntry& entry, NodeId node);

/// The same of its ParameterValue (of a DCF), or else of its DefaultValue.
std::optional<std::int64_t> configured_number(const ObjectEntry& entry, NodeId node);

/// The bytes of an object at power-on: ParameterValue, else DefaultValue, else zeros. As many as the type has; a
/// visible string's characters; empty for other types.
std::vector<std::uint8_t> configured_bytes(const ObjectEntry& entry, NodeId node);

}  // namespace mrroc::canopen
