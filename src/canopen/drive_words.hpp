#pragma once

#include <cstdint>
#include <string>

#include "canopen/drive_state.hpp"

namespace mrroc::canopen {

/// What a controlword (6040h) commands in this mode: "enable operation", "enable operation, start homing". Any word
/// whatsoever; not for the real-time path, as all of this file.
std::string controlword_text(std::uint16_t controlword, DriveMode mode);

/// What a statusword (6041h) tells in this mode: "operation enabled, follows command".
std::string statusword_text(std::uint16_t statusword, DriveMode mode);

/// The switches that are closed in the digital inputs (60FDh): "positive limit switch, home switch"; "no switch".
std::string switches_text(std::uint32_t inputs);

}  // namespace mrroc::canopen
