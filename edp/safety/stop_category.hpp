#pragma once

#include <cstdint>

#include "mrroc/errors.hpp"

namespace mrroc::edp {

/// The stop categories of IEC 60204-1, 9.2.2.
enum class StopCategory : std::uint8_t {
  drives_off = 0,     ///< the drives lose their power at once: their brakes stop the robot
  stop_then_off = 1,  ///< along the jerk-limited Stop, or in step (is_urgent), then the drives go off
  stop_and_hold = 2   ///< along the jerk-limited Stop, then the drives hold the robot where it is
};

/// How the servo stops its robot for `reason`; `none`: no further command (a command is late, its ECP is silent, or the
/// motion has ended). Categories 0 and 1 latch a fault, 2 does not.
constexpr StopCategory stop_category(ErrorCode reason) noexcept {
  switch (reason) {
    // a drive that is broken, silent or without a known position follows no stop: a controlled stop would be a motion
    // without feedback
    case ErrorCode::drive_fault:
    case ErrorCode::hardware_silent:
    case ErrorCode::encoder_fault:
    case ErrorCode::overspeed:
    case ErrorCode::axis_stuck:
    case ErrorCode::bus_off:
    case ErrorCode::drive_not_ready:
    case ErrorCode::heartbeat_lost:
    case ErrorCode::drive_restarted:
      return StopCategory::drives_off;
    // nothing is broken: the robot can accept commands at once, and power holds it against its weight
    case ErrorCode::none:
    case ErrorCode::force_limit:
    case ErrorCode::sensor_not_ready:
    case ErrorCode::sensor_out_of_range:
    case ErrorCode::sensor_hardware:
      return StopCategory::stop_and_hold;
    // an obstacle or a person in danger, and the drives still follow: a stop within the limits, without power after it,
    // the shortest one where it is urgent. This is also the default for unforeseen causes.
    case ErrorCode::emergency_stop:
    case ErrorCode::following_error:
    case ErrorCode::over_current:
    case ErrorCode::limit_switch:
    case ErrorCode::bus_error:  // it still carries frames
    case ErrorCode::io_fault:
    case ErrorCode::synchronisation_failed:
    case ErrorCode::not_enabled:  // switched off by order, or the deployment ends
    default:                      // a set-point that passes a limit, invalid joints
      return StopCategory::stop_then_off;
  }
}

/// Whether the robot does not follow its set-point for this reason: something is in its way, or its drives are too
/// weak. The stop then begins where the robot is, at its own velocity. From the set-point it would lead on into an
/// obstacle.
constexpr bool is_hindered(ErrorCode reason) noexcept {
  return reason == ErrorCode::following_error || reason == ErrorCode::over_current;
}

/// Whether a stop of category 1 is the shortest one also of a robot that shares its motion with others: an obstacle, a
/// person in danger, a set-point beyond a limit. For other reasons it brakes in step with them.
constexpr bool is_urgent(ErrorCode reason) noexcept {
  return reason != ErrorCode::not_enabled && reason != ErrorCode::bus_error && reason != ErrorCode::io_fault;
}

/// Whether a fault stops the robot more sharply than an earlier one; `none` means no fault.
constexpr bool graver(ErrorCode fault, ErrorCode found) noexcept {
  if (fault == ErrorCode::none) return false;
  return found == ErrorCode::none || stop_category(fault) < stop_category(found);
}

}  // namespace mrroc::edp
