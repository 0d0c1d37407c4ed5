#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/ur/rtde/value.hpp"

namespace mrroc::ur {

/// Numbers of the RTDE guide.
enum class RobotMode : std::int32_t {
  no_controller = -1,
  disconnected = 0,
  confirm_safety = 1,
  booting = 2,
  power_off = 3,
  power_on = 4,
  idle = 5,  ///< powered, the brakes are closed
  backdrive = 6,
  running = 7,
  updating_firmware = 8
};
enum class SafetyMode : std::int32_t {
  normal = 1,
  reduced = 2,
  protective_stop = 3,
  recovery = 4,
  safeguard_stop = 5,
  system_emergency_stop = 6,
  robot_emergency_stop = 7,
  violation = 8,
  fault = 9,
  validate_joint_id = 10,
  undefined = 11,
  automatic_safeguard_stop = 12,
  three_position_stop = 13
};
enum class JointMode : std::int32_t {
  reset = 235,
  shutting_down = 236,
  backdrive = 238,
  power_off = 239,
  ready_for_power_off = 240,
  not_responding = 245,
  motor_initialisation = 246,
  booting = 247,
  bootloader = 249,
  violation = 251,
  fault = 252,
  running = 253,
  idle = 255
};
enum class RuntimeState : std::uint32_t { stopping, stopped, playing, pausing, paused, resuming };

/// The state that the control script reports in its first output register.
enum class ScriptState : std::int32_t {
  none = 0,
  holding = 1,  ///< at rest, the set-points are ignored
  following_position = 2,
  following_velocity = 3,
  stopping = 4,
  ended = 5  ///< set-points were missing: stopped, and the program has ended
};

/// As in the manuals, such as "POWER_OFF"; "unknown" for another number. Any thread; allocates nothing.
std::string_view name_of(RobotMode mode) noexcept;
std::string_view name_of(SafetyMode mode) noexcept;
std::string_view name_of(JointMode mode) noexcept;
std::string_view name_of(RuntimeState state) noexcept;

/// One package of the controller.
struct RobotState {
  double timestamp = 0;              ///< s, of the controller
  rtde::Vector6d position{};         ///< rad
  rtde::Vector6d velocity{};         ///< rad/s
  rtde::Vector6d target_position{};  ///< rad
  rtde::Vector6d current{};          ///< A
  rtde::Vector6Int32 joint_mode{};   ///< JointMode
  rtde::Vector6d wrench{};           ///< actual_TCP_force: N, N m, at the tool, in the base frame
  rtde::Vector6d tool_pose{};        ///< actual_TCP_pose: m and rotation vector, in the base frame
  RobotMode robot_mode = RobotMode::no_controller;
  SafetyMode safety_mode = SafetyMode::undefined;
  RuntimeState runtime = RuntimeState::stopped;
  std::uint32_t robot_status = 0;   ///< bit 0: power, 1: a program runs
  std::uint32_t safety_status = 0;  ///< bits, see the guide
  double speed_scaling = 0;         ///< 0 to 1, of the program's motion
  std::uint64_t digital_inputs = 0;
  std::array<double, 4> analog_inputs{};  ///< standard 0 and 1, of the tool 0 and 1; V or A
  ScriptState script = ScriptState::none;
  std::int32_t script_sequence = 0;  ///< of the set-points that the script executes
  std::int32_t script_program = 0;   ///< number of the uploaded program
  std::int64_t received = 0;         ///< CLOCK_MONOTONIC, ns
  std::uint64_t number = 0;          ///< counts the packages from 1

  bool program_runs() const noexcept { return (robot_status & 2u) != 0 && runtime == RuntimeState::playing; }
};

/// The fields of a package, with the output registers from `registers` on.
std::vector<std::string> state_fields(int registers);
/// Fills `state`; false: a value is of another type. Allocates nothing.
bool read_state(std::span<const rtde::Value> values, RobotState& state) noexcept;

}  // namespace mrroc::ur
