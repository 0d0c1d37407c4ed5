#pragma once

#include <cstdint>
#include <variant>

#include "drivers/ur/robot_state.hpp"
#include "edp/safety/fault.hpp"

namespace mrroc::ur {

/// No package for `periods` controller periods.
struct SilentController {
  static constexpr ErrorCode kCode = ErrorCode::hardware_silent;
  std::uint64_t periods = 0;
  edp::DriverText problem;  ///< of the connection; empty: it is open
};

/// The controller has stopped the robot because it met an obstacle, a limit or another protection.
struct ProtectiveStop {
  static constexpr ErrorCode kCode = ErrorCode::drive_fault;
};

struct EmergencyStop {
  static constexpr ErrorCode kCode = ErrorCode::emergency_stop;
  SafetyMode mode = SafetyMode::robot_emergency_stop;
};

/// A safeguard input is open.
struct SafeguardStop {
  static constexpr ErrorCode kCode = ErrorCode::drive_not_ready;
  SafetyMode mode = SafetyMode::safeguard_stop;
};

/// A violation or a fault of the safety system, or a recovery mode: only the teach pendant leaves it.
struct SafetyFault {
  static constexpr ErrorCode kCode = ErrorCode::drive_fault;
  SafetyMode mode = SafetyMode::fault;
};

/// A joint is not in its running state while the robot is.
struct JointFault {
  static constexpr ErrorCode kCode = ErrorCode::drive_fault;
  int axis = 0;
  JointMode mode = JointMode::fault;
};

/// The arm has no power, or its brakes are closed.
struct PowerOff {
  static constexpr ErrorCode kCode = ErrorCode::drive_not_ready;
  RobotMode mode = RobotMode::power_off;
};

/// The controller takes no program because its teach pendant has the control.
struct NotInRemoteControl {
  static constexpr ErrorCode kCode = ErrorCode::drive_not_ready;
};

/// The control script has been stopped, paused or replaced.
struct ProgramStopped {
  static constexpr ErrorCode kCode = ErrorCode::drive_not_ready;
  RuntimeState state = RuntimeState::stopped;
};

/// The control script has stopped the robot because set-points were missing.
struct SetPointsMissing {
  static constexpr ErrorCode kCode = ErrorCode::drive_not_ready;
};

/// The robot could not be made ready.
struct StartFailed {
  static constexpr ErrorCode kCode = ErrorCode::drive_not_ready;
  edp::DriverText reason;
};

/// A fault of the robot; monostate: none.
using UrFault =
    std::variant<std::monostate, SilentController, ProtectiveStop, EmergencyStop, SafeguardStop, SafetyFault,
                 JointFault, PowerOff, NotInRemoteControl, ProgramStopped, SetPointsMissing, StartFailed>;

/// `kCode` of the alternative; `none` without a fault.
ErrorCode code_of(const UrFault& fault) noexcept;
/// Its axis from 0; -1: the whole robot.
int axis_of(const UrFault& fault) noexcept;
/// Text of the fault. Allocates nothing, never throws.
edp::DriverText describe(const UrFault& fault) noexcept;

/// The fault of the safety system or of a joint that a package reports. Allocates nothing, never throws.
UrFault safety_fault(const RobotState& state) noexcept;
/// The fault of a robot that should execute the control script `program`.
UrFault following_fault(const RobotState& state, std::int32_t program) noexcept;

}  // namespace mrroc::ur
