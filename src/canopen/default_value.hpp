#pragma once

#include <cstdint>
#include <optional>

#include "canopen/eds_file.hpp"
#include "canopen/identifiers.hpp"

namespace mrroc::canopen {

/// The number that an object of `node` has when the power comes on, as an EDS file says it: "384", "0x180",
/// "$NODEID+0x180", "0x180+$NODEID" (CiA 306-1). Nothing: the file has none, or no number.
std::optional<std::int64_t> default_number(const ObjectEntry& entry, NodeId node);

}  // namespace mrroc::canopen
