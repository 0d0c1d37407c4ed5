#pragma once

#include <cstdint>

namespace mrroc::edp {

/// State of the power of a robot's drives.
///
///   off -> powering, on                          enable; the drives may take some time
///   off, powering -> cleared                     recover: the faults of the drives are reset
///   cleared -> powering_cleared, on              the next reading has no fault
///   powering, powering_cleared -> on             all drives have power
///   cleared, powering, powering_cleared -> off   a fault remains or occurs, disable, the process ends
///   on -> stopping                               disable, the process ends, a fault with which the drives can still
///   stop on, stopping -> off                          any other fault; the end of the stop
enum class ServoState : std::uint8_t {
  off,
  cleared,           ///< off; the faults of the drives have been reset
  powering,          ///< the drives are being switched on
  powering_cleared,  ///< the same after a reset
  on,
  stopping,  ///< on; the drives are switched off at the end of the stop
};

/// The drives have power and the servo regulates.
constexpr bool has_power(ServoState state) noexcept { return state == ServoState::on || state == ServoState::stopping; }

/// The drives have been commanded to take power and do not have it yet.
constexpr bool is_powering(ServoState state) noexcept {
  return state == ServoState::powering || state == ServoState::powering_cleared;
}

/// The faults of the drives have been reset for the present order to recover.
constexpr bool is_cleared(ServoState state) noexcept {
  return state == ServoState::cleared || state == ServoState::powering_cleared;
}

}  // namespace mrroc::edp
