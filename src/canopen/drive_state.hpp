#pragma once

#include <cstdint>
#include <string_view>

namespace mrroc::canopen {

/// The states of a drive (CiA 402-2, 6.2: the power drive system's finite state automaton).
enum class DriveState : std::uint8_t {
  not_ready_to_switch_on,
  switch_on_disabled,
  ready_to_switch_on,
  switched_on,
  operation_enabled,
  quick_stop_active,
  fault_reaction_active,
  fault
};

/// Modes of operation (6060h) that this framework uses.
enum class DriveMode : std::int8_t {
  none = 0,
  homing = 6,
  cyclic_position = 8,
  cyclic_velocity = 9,
  cyclic_torque = 10
};

// commands of the controlword (6040h)
inline constexpr std::uint16_t kDisableVoltage = 0x00;
inline constexpr std::uint16_t kQuickStop = 0x02;
inline constexpr std::uint16_t kShutdown = 0x06;
inline constexpr std::uint16_t kSwitchOn = 0x07;
inline constexpr std::uint16_t kEnableOperation = 0x0f;
inline constexpr std::uint16_t kStartHoming = 0x10;  ///< together with kEnableOperation, in the homing mode
inline constexpr std::uint16_t kFaultReset = 0x80;   ///< at its rising edge

// bits of the statusword (6041h) other than the state
inline constexpr std::uint16_t kTargetReached = 1u << 10;
inline constexpr std::uint16_t kInternalLimit = 1u << 11;
inline constexpr std::uint16_t kFollowsCommand = 1u << 12;  ///< cyclic modes
inline constexpr std::uint16_t kHomingAttained = 1u << 12;  ///< homing mode
inline constexpr std::uint16_t kFollowingError = 1u << 13;  ///< cyclic synchronous position
inline constexpr std::uint16_t kHomingError = 1u << 13;     ///< homing mode

/// The state in a statusword: its bits 0..3, 5 and 6. Invalid combinations are `not_ready_to_switch_on`.
DriveState drive_state(std::uint16_t statusword) noexcept;

/// A statusword's bits of a state, with voltage enabled (bit 4) in states with power.
std::uint16_t status_bits(DriveState state) noexcept;

/// The controlword that brings a drive from `state` one step nearer to operation enabled; 0 where this is not allowed:
/// a fault must be reset first, a fault reaction must end.
std::uint16_t towards_operation(DriveState state) noexcept;

/// The state after a controlword in `state`, with `before` the previous controlword: the transitions of CiA 402-2
/// except those that the drive makes on its own. A quick stop is entered from operation enabled only.
DriveState commanded_state(DriveState state, std::uint16_t controlword, std::uint16_t before) noexcept;

/// "operation enabled".
std::string_view describe(DriveState state) noexcept;

/// "cyclic synchronous position".
std::string_view describe(DriveMode mode) noexcept;

}  // namespace mrroc::canopen
