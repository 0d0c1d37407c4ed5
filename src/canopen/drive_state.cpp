#include "canopen/drive_state.hpp"

#include <array>

namespace mrroc::canopen {

namespace {

struct Pattern {
  std::uint16_t mask;
  std::uint16_t bits;
  DriveState state;
};

// CiA 402-2, table of the statusword's state bits
constexpr std::array<Pattern, 8> kPatterns{{
    {0x4f, 0x00, DriveState::not_ready_to_switch_on},
    {0x4f, 0x40, DriveState::switch_on_disabled},
    {0x6f, 0x21, DriveState::ready_to_switch_on},
    {0x6f, 0x23, DriveState::switched_on},
    {0x6f, 0x27, DriveState::operation_enabled},
    {0x6f, 0x07, DriveState::quick_stop_active},
    {0x4f, 0x0f, DriveState::fault_reaction_active},
    {0x4f, 0x08, DriveState::fault},
}};

constexpr std::uint16_t kVoltageEnabled = 1u << 4;
constexpr std::uint16_t kCommandBits = 0x8f;

}  // namespace

DriveState drive_state(std::uint16_t statusword) noexcept {
  for (const Pattern& pattern : kPatterns)
    if ((statusword & pattern.mask) == pattern.bits) return pattern.state;
  return DriveState::not_ready_to_switch_on;
}

std::uint16_t status_bits(DriveState state) noexcept {
  for (const Pattern& pattern : kPatterns) {
    if (pattern.state != state) continue;
    const bool powered = state == DriveState::switched_on || state == DriveState::operation_enabled ||
                         state == DriveState::quick_stop_active || state == DriveState::fault_reaction_active;
    return static_cast<std::uint16_t>(pattern.bits | (powered ? kVoltageEnabled : 0));
  }
  return 0;
}

std::uint16_t towards_operation(DriveState state) noexcept {
  switch (state) {
    case DriveState::switch_on_disabled:
      return kShutdown;
    case DriveState::ready_to_switch_on:
      return kSwitchOn;
    case DriveState::switched_on:
    case DriveState::operation_enabled:
      return kEnableOperation;
    case DriveState::quick_stop_active:  // through switch on disabled: a requested stop is not cancelled
    case DriveState::not_ready_to_switch_on:
    case DriveState::fault_reaction_active:
    case DriveState::fault:
      break;
  }
  return kDisableVoltage;
}

DriveState commanded_state(DriveState state, std::uint16_t controlword, std::uint16_t before) noexcept {
  if (state == DriveState::fault)
    return (controlword & kFaultReset) != 0 && (before & kFaultReset) == 0 ? DriveState::switch_on_disabled : state;
  if (state == DriveState::not_ready_to_switch_on || state == DriveState::fault_reaction_active) return state;
  const std::uint16_t command = controlword & kCommandBits;
  const bool voltage = (command & 0x02) != 0;
  const bool no_quick_stop = (command & 0x04) != 0;
  if (!voltage) return DriveState::switch_on_disabled;
  if (!no_quick_stop) {
    if (state == DriveState::operation_enabled || state == DriveState::quick_stop_active)
      return DriveState::quick_stop_active;
    return DriveState::switch_on_disabled;
  }
  if (state == DriveState::quick_stop_active) return state;
  if ((command & 0x01) == 0) return DriveState::ready_to_switch_on;
  if (state == DriveState::switch_on_disabled) return state;  // it needs a shutdown first
  const bool enable = (command & 0x08) != 0;
  if (state == DriveState::ready_to_switch_on) return DriveState::switched_on;
  return enable ? DriveState::operation_enabled : DriveState::switched_on;
}

std::string_view describe(DriveState state) noexcept {
  switch (state) {
    case DriveState::not_ready_to_switch_on:
      return "not ready to switch on";
    case DriveState::switch_on_disabled:
      return "switch on disabled";
    case DriveState::ready_to_switch_on:
      return "ready to switch on";
    case DriveState::switched_on:
      return "switched on";
    case DriveState::operation_enabled:
      return "operation enabled";
    case DriveState::quick_stop_active:
      return "quick stop active";
    case DriveState::fault_reaction_active:
      return "fault reaction active";
    case DriveState::fault:
      return "fault";
  }
  return "unknown";
}

std::string_view describe(DriveMode mode) noexcept {
  switch (mode) {
    case DriveMode::none:
      return "none";
    case DriveMode::homing:
      return "homing";
    case DriveMode::cyclic_position:
      return "cyclic synchronous position";
    case DriveMode::cyclic_velocity:
      return "cyclic synchronous velocity";
    case DriveMode::cyclic_torque:
      return "cyclic synchronous torque";
  }
  return "another";
}

}  // namespace mrroc::canopen
