#pragma once

#include <cstdint>
#include <string>

#include "canopen/drive_state.hpp"

namespace mrroc::canopen {

/// The text of a controlword (6040h) in this mode: "enable operation", "enable operation, start homing". Any value is
/// allowed; not for the real-time path, like this whole file.
std::string controlword_text(std::uint16_t controlword, DriveMode mode);

/// The text of a statusword (6041h) in this mode: "operation enabled, follows command".
std::string statusword_text(std::uint16_t statusword, DriveMode mode);

/// The switches that are closed in the digital inputs (60FDh): "positive limit switch, home switch"; "no switch".
std::string switches_text(std::uint32_t inputs);

}  // namespace mrroc::canopen
