#include "drivers/ur/robot_state.hpp"

namespace mrroc::ur {
namespace {

/// Takes the values of a package one after the other, each with the type of its destination.
class ValueReader {
 public:
  explicit ValueReader(std::span<const rtde::Value> values) noexcept : values_(values) {}

  template <class T>
  ValueReader& take(T& to) noexcept {
    const T* const value = next_ < values_.size() ? std::get_if<T>(&values_[next_]) : nullptr;
    ++next_;
    ok_ = ok_ && value != nullptr;
    if (value != nullptr) to = *value;
    return *this;
  }

  template <class Number, class Enum>
  ValueReader& take_as(Enum& to) noexcept {
    Number number{};
    take(number);
    to = static_cast<Enum>(number);
    return *this;
  }

  bool complete() const noexcept { return ok_ && next_ == values_.size(); }

 private:
  std::span<const rtde::Value> values_;
  std::size_t next_ = 0;
  bool ok_ = true;
};

}  // namespace

std::vector<std::string> state_fields(int registers) {
  std::vector<std::string> fields{"timestamp",
                                  "actual_q",
                                  "actual_qd",
                                  "target_q",
                                  "actual_current",
                                  "joint_mode",
                                  "actual_TCP_force",
                                  "actual_TCP_pose",
                                  "robot_mode",
                                  "safety_mode",
                                  "runtime_state",
                                  "robot_status_bits",
                                  "safety_status_bits",
                                  "speed_scaling",
                                  "actual_digital_input_bits",
                                  "standard_analog_input0",
                                  "standard_analog_input1",
                                  "tool_analog_input0",
                                  "tool_analog_input1"};
  for (int i = 0; i < 3; ++i) fields.push_back("output_int_register_" + std::to_string(registers + i));
  return fields;
}

bool read_state(std::span<const rtde::Value> values, RobotState& state) noexcept {
  ValueReader reader(values);
  reader.take(state.timestamp)
      .take(state.position)
      .take(state.velocity)
      .take(state.target_position)
      .take(state.current)
      .take(state.joint_mode)
      .take(state.wrench)
      .take(state.tool_pose)
      .take_as<std::int32_t>(state.robot_mode)
      .take_as<std::int32_t>(state.safety_mode)
      .take_as<std::uint32_t>(state.runtime)
      .take(state.robot_status)
      .take(state.safety_status)
      .take(state.speed_scaling)
      .take(state.digital_inputs)
      .take(state.analog_inputs[0])
      .take(state.analog_inputs[1])
      .take(state.analog_inputs[2])
      .take(state.analog_inputs[3])
      .take_as<std::int32_t>(state.script)
      .take(state.script_sequence)
      .take(state.script_program);
  return reader.complete();
}

std::string_view name_of(RobotMode mode) noexcept {
  switch (mode) {
    case RobotMode::no_controller:
      return "NO_CONTROLLER";
    case RobotMode::disconnected:
      return "DISCONNECTED";
    case RobotMode::confirm_safety:
      return "CONFIRM_SAFETY";
    case RobotMode::booting:
      return "BOOTING";
    case RobotMode::power_off:
      return "POWER_OFF";
    case RobotMode::power_on:
      return "POWER_ON";
    case RobotMode::idle:
      return "IDLE";
    case RobotMode::backdrive:
      return "BACKDRIVE";
    case RobotMode::running:
      return "RUNNING";
    case RobotMode::updating_firmware:
      return "UPDATING_FIRMWARE";
  }
  return "unknown";
}

std::string_view name_of(SafetyMode mode) noexcept {
  switch (mode) {
    case SafetyMode::normal:
      return "NORMAL";
    case SafetyMode::reduced:
      return "REDUCED";
    case SafetyMode::protective_stop:
      return "PROTECTIVE_STOP";
    case SafetyMode::recovery:
      return "RECOVERY";
    case SafetyMode::safeguard_stop:
      return "SAFEGUARD_STOP";
    case SafetyMode::system_emergency_stop:
      return "SYSTEM_EMERGENCY_STOP";
    case SafetyMode::robot_emergency_stop:
      return "ROBOT_EMERGENCY_STOP";
    case SafetyMode::violation:
      return "VIOLATION";
    case SafetyMode::fault:
      return "FAULT";
    case SafetyMode::validate_joint_id:
      return "VALIDATE_JOINT_ID";
    case SafetyMode::undefined:
      return "UNDEFINED_SAFETY_MODE";
    case SafetyMode::automatic_safeguard_stop:
      return "AUTOMATIC_MODE_SAFEGUARD_STOP";
    case SafetyMode::three_position_stop:
      return "SYSTEM_THREE_POSITION_ENABLING_STOP";
  }
  return "unknown";
}

std::string_view name_of(JointMode mode) noexcept {
  switch (mode) {
    case JointMode::reset:
      return "RESET";
    case JointMode::shutting_down:
      return "SHUTTING_DOWN";
    case JointMode::backdrive:
      return "BACKDRIVE";
    case JointMode::power_off:
      return "POWER_OFF";
    case JointMode::ready_for_power_off:
      return "READY_FOR_POWER_OFF";
    case JointMode::not_responding:
      return "NOT_RESPONDING";
    case JointMode::motor_initialisation:
      return "MOTOR_INITIALISATION";
    case JointMode::booting:
      return "BOOTING";
    case JointMode::bootloader:
      return "BOOTLOADER";
    case JointMode::violation:
      return "VIOLATION";
    case JointMode::fault:
      return "FAULT";
    case JointMode::running:
      return "RUNNING";
    case JointMode::idle:
      return "IDLE";
  }
  return "unknown";
}

std::string_view name_of(RuntimeState state) noexcept {
  switch (state) {
    case RuntimeState::stopping:
      return "STOPPING";
    case RuntimeState::stopped:
      return "STOPPED";
    case RuntimeState::playing:
      return "PLAYING";
    case RuntimeState::pausing:
      return "PAUSING";
    case RuntimeState::paused:
      return "PAUSED";
    case RuntimeState::resuming:
      return "RESUMING";
  }
  return "unknown";
}

}  // namespace mrroc::ur
