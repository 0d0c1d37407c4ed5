#pragma once

#include <cstdint>

namespace mrroc::edp {

/// How a drive on a bus is silent: `value` of the fault hardware_silent of drives on a bus.
enum class DriveSilence : std::uint8_t {
  no_answer,
  late,       ///< it does answer, after the time for it
  no_status,  ///< no PDO of velocity and switches
  nobody      ///< no drive of the bus answers: without an axis
};

}  // namespace mrroc::edp
