#include "sim/ur/virtual_controller.hpp"

#include <algorithm>
#include <regex>
#include <stdexcept>
#include <utility>

namespace mrroc::sim::ur {
namespace {

using mrroc::ur::name_of;
using mrroc::ur::rtde::FieldType;
using mrroc::ur::rtde::Value;
using mrroc::ur::rtde::Vector3d;
using mrroc::ur::rtde::Vector6d;
using mrroc::ur::rtde::Vector6Int32;

constexpr double kAnalogRange = 10;  // V

void merge(std::uint64_t& bits, unsigned shift, std::uint8_t mask, std::uint8_t values) noexcept {
  const std::uint64_t all = static_cast<std::uint64_t>(mask) << shift;
  bits = (bits & ~all) | ((static_cast<std::uint64_t>(values) << shift) & all);
}

bool is_emergency(SafetyMode mode) noexcept {
  return mode == SafetyMode::robot_emergency_stop || mode == SafetyMode::system_emergency_stop;
}

}  // namespace

VirtualController::VirtualController(Options options, std::unique_ptr<JointPlant> plant)
    : options_(options), plant_(std::move(plant)), motion_(options.period) {
  fill_outputs();
  fill_inputs();
  if (options_.powered) robot_mode_ = next_mode_ = RobotMode::running;
}

void VirtualController::fill_outputs() {
  const auto six = [](double value) { return [value] { return Vector6d{value, value, value, value, value, value}; }; };
  const auto real = [](double value) { return [value] { return value; }; };
  const auto three = [] { return Vector3d{}; };
  outputs_["timestamp"] = [this] { return time_; };
  outputs_["actual_q"] = [this] {
    Six position = plant_->position();
    position[0] += false_by_;
    return position;
  };
  outputs_["actual_qd"] = [this] { return plant_->velocity(); };
  outputs_["target_q"] = [this] {
    return targets_.kind == JointTargets::Kind::position ? targets_.position : plant_->position();
  };
  outputs_["target_qd"] = [this] { return targets_.velocity; };
  for (const char* name :
       {"target_qdd", "target_current", "target_moment", "actual_current", "actual_current_window",
        "joint_control_output", "actual_TCP_pose", "actual_TCP_speed", "actual_TCP_force", "target_TCP_pose",
        "target_TCP_speed", "ft_raw_wrench", "payload_inertia", "actual_current_as_torque"})
    outputs_[name] = six(0);
  outputs_["joint_temperatures"] = six(30);
  outputs_["actual_joint_voltage"] = six(48);
  for (const char* name : {"actual_tool_accelerometer", "payload_cog", "elbow_position", "elbow_velocity"})
    outputs_[name] = three;
  for (const char* name : {"actual_execution_time", "actual_momentum", "actual_robot_current", "io_current",
                           "tcp_force_scalar", "tool_output_current"})
    outputs_[name] = real(0);
  for (const char* name : {"actual_main_voltage", "actual_robot_voltage"}) outputs_[name] = real(48);
  outputs_["payload"] = [this] { return payload_; };
  outputs_["speed_scaling"] = real(1);
  outputs_["target_speed_fraction"] = [this] { return speed_slider_; };
  outputs_["actual_digital_input_bits"] = [this] { return digital_inputs_; };
  outputs_["actual_digital_output_bits"] = [this] { return digital_outputs_; };
  outputs_["robot_mode"] = [this] { return static_cast<std::int32_t>(robot_mode_); };
  outputs_["safety_mode"] = outputs_["safety_status"] = [this] { return static_cast<std::int32_t>(safety_mode_); };
  outputs_["joint_mode"] = [this] {
    Vector6Int32 modes{};
    for (std::size_t i = 0; i < modes.size(); ++i) modes[i] = static_cast<std::int32_t>(joint_mode(i));
    return modes;
  };
  outputs_["runtime_state"] = [this] { return static_cast<std::uint32_t>(runtime()); };
  outputs_["robot_status_bits"] = [this] { return robot_status(); };
  outputs_["safety_status_bits"] = [this] { return safety_status(); };
  outputs_["analog_io_types"] = [] { return std::uint32_t{0xf}; };
  outputs_["tool_output_voltage"] = [this] { return static_cast<std::int32_t>(tool_voltage_); };
  for (std::size_t i = 0; i < 2; ++i) {
    outputs_["standard_analog_input" + std::to_string(i)] = [this, i] { return analog_inputs_[i]; };
    outputs_["standard_analog_output" + std::to_string(i)] = [this, i] { return analog_outputs_[i]; };
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(kRegisters); ++i) {
    const std::string number = std::to_string(i);
    outputs_["output_int_register_" + number] = [this, i] { return registers_.integer_outputs[i]; };
    outputs_["output_double_register_" + number] = [this, i] { return registers_.real_outputs[i]; };
    outputs_["input_int_register_" + number] = [this, i] { return registers_.integer_inputs[i]; };
    outputs_["input_double_register_" + number] = [this, i] { return registers_.real_inputs[i]; };
  }
}

void VirtualController::fill_inputs() {
  const auto uint8 = [this](const char* name, auto set) {
    inputs_[name] = {FieldType::uint8, [set](const Value& value) { set(std::get<std::uint8_t>(value)); }};
  };
  const auto real = [this](const std::string& name, auto set) {
    inputs_[name] = {FieldType::real, [set](const Value& value) { set(std::get<double>(value)); }};
  };
  uint8("standard_digital_output_mask", [this](std::uint8_t mask) { standard_mask_ = mask; });
  uint8("standard_digital_output",
        [this](std::uint8_t values) { merge(digital_outputs_, 0, std::exchange(standard_mask_, {}), values); });
  uint8("configurable_digital_output_mask", [this](std::uint8_t mask) { configurable_mask_ = mask; });
  uint8("configurable_digital_output",
        [this](std::uint8_t values) { merge(digital_outputs_, 8, std::exchange(configurable_mask_, {}), values); });
  uint8("tool_digital_output_mask", [this](std::uint8_t mask) { tool_mask_ = mask; });
  uint8("tool_digital_output",
        [this](std::uint8_t values) { merge(digital_outputs_, 16, std::exchange(tool_mask_, {}), values); });
  uint8("standard_analog_output_mask", [this](std::uint8_t mask) { analog_mask_ = mask; });
  uint8("standard_analog_output_type", [](std::uint8_t) {});
  for (std::size_t i = 0; i < 2; ++i)
    real("standard_analog_output_" + std::to_string(i), [this, i](double fraction) {
      if ((analog_mask_ >> i & 1) != 0) analog_outputs_[i] = kAnalogRange * std::clamp(fraction, 0.0, 1.0);
    });
  inputs_["speed_slider_mask"] = {FieldType::uint32,
                                  [this](const Value& value) { slider_mask_ = std::get<std::uint32_t>(value); }};
  real("speed_slider_fraction", [this](double fraction) {
    if (std::exchange(slider_mask_, 0u) != 0) speed_slider_ = std::clamp(fraction, 0.0, 1.0);
  });
  inputs_["external_force_torque"] = {FieldType::vector6d, [](const Value&) {}};
  for (std::size_t i = 0; i < static_cast<std::size_t>(kRegisters); ++i) {
    inputs_["input_int_register_" + std::to_string(i)] = {
        FieldType::int32,
        [this, i](const Value& value) { registers_.integer_inputs[i] = std::get<std::int32_t>(value); }};
    real("input_double_register_" + std::to_string(i), [this, i](double value) { registers_.real_inputs[i] = value; });
  }
}

const VirtualController::Getter* VirtualController::output(const std::string& name) const {
  const auto found = outputs_.find(name);
  return found == outputs_.end() ? nullptr : &found->second;
}

const VirtualController::Input* VirtualController::input(const std::string& name) const {
  const auto found = inputs_.find(name);
  return found == inputs_.end() ? nullptr : &found->second;
}

void VirtualController::step() {
  time_ = static_cast<double>(++periods_) * options_.period;
  advance_power();
  run_program();
  const bool released = robot_mode_ == RobotMode::running && !is_emergency(safety_mode_);
  targets_ = released ? motion_.targets(*plant_) : JointTargets{};
  plant_->step(targets_, options_.period);
}

void VirtualController::advance_power() noexcept {
  if (robot_mode_ == next_mode_ || time_ < mode_at_) return;
  robot_mode_ = next_mode_;
  // power on ends with closed brakes
  if (robot_mode_ == RobotMode::power_on) {
    next_mode_ = RobotMode::idle;
    mode_at_ = time_ + kPowerTime;
  }
}

void VirtualController::run_program() {
  if (!program_) return;
  ProgramSurroundings around{registers_, motion_, *plant_, options_.period};
  if (!program_->step(around)) program_.reset();
}

void VirtualController::restart() {
  time_ = 0;
  periods_ = 0;
  program_.reset();
  motion_.cancel();
  registers_ = {};
  safety_mode_ = SafetyMode::normal;
  failed_joint_.reset();
  robot_mode_ = RobotMode::booting;
  next_mode_ = RobotMode::power_off;
  mode_at_ = kBootTime;
}

void VirtualController::halt(SafetyMode mode) noexcept {
  safety_mode_ = mode;
  stopped_at_ = time_;
  program_.reset();
  motion_.cancel();
}

void VirtualController::protective_stop() noexcept { halt(SafetyMode::protective_stop); }

void VirtualController::emergency_stop(bool pressed) noexcept {
  if (pressed) {
    halt(SafetyMode::robot_emergency_stop);
    power_off();
  } else if (is_emergency(safety_mode_)) {
    safety_mode_ = SafetyMode::normal;
  }
}

void VirtualController::safeguard_stop(bool open) noexcept {
  if (open)
    halt(SafetyMode::safeguard_stop);
  else if (safety_mode_ == SafetyMode::safeguard_stop)
    safety_mode_ = SafetyMode::normal;
}

void VirtualController::power_off() noexcept {
  program_.reset();
  motion_.cancel();
  robot_mode_ = next_mode_ = RobotMode::power_off;
  failed_joint_.reset();
}

void VirtualController::fail_joint(std::size_t axis) noexcept {
  failed_joint_ = axis;
  program_.reset();
  motion_.cancel();
}

void VirtualController::stop_program() noexcept {
  program_.reset();
  motion_.cancel();
}

void VirtualController::set_inputs(std::uint64_t digital, double analog0, double analog1) noexcept {
  digital_inputs_ = digital;
  analog_inputs_ = {analog0, analog1};
}

std::uint32_t VirtualController::robot_status() const noexcept {
  const bool power = robot_mode_ == RobotMode::idle || robot_mode_ == RobotMode::running;
  return (power ? 1u : 0u) | (program_ ? 2u : 0u);
}

std::uint32_t VirtualController::safety_status() const noexcept {
  constexpr std::uint32_t kStopped = 1u << 10, kEmergency = 1u << 7;
  switch (safety_mode_) {
    case SafetyMode::normal:
      return 1u;
    case SafetyMode::protective_stop:
      return 1u << 2 | kStopped;
    case SafetyMode::safeguard_stop:
      return 1u << 4 | kStopped;
    case SafetyMode::system_emergency_stop:
      return 1u << 5 | kEmergency | kStopped;
    case SafetyMode::robot_emergency_stop:
      return 1u << 6 | kEmergency | kStopped;
    default:
      return kStopped;
  }
}

JointMode VirtualController::joint_mode(std::size_t axis) const noexcept {
  if (failed_joint_ == axis) return JointMode::fault;
  if (robot_mode_ == RobotMode::running) return JointMode::running;
  if (robot_mode_ == RobotMode::idle) return JointMode::idle;
  return JointMode::power_off;
}

bool VirtualController::start_program(const std::string& text) {
  if (!remote_ || robot_mode_ != RobotMode::running || safety_mode_ != SafetyMode::normal || failed_joint_)
    return false;
  try {
    motion_.cancel();
    program_ = make_program(text);
  } catch (const std::invalid_argument&) {
    return false;
  }
  std::smatch match;
  if (std::regex_search(text, match, std::regex("\\n\\s*set_payload\\(([0-9.e+-]+)")))
    payload_ = std::stod(match[1].str());
  if (std::regex_search(text, match, std::regex("\\n\\s*set_tool_voltage\\((\\d+)\\)")))
    tool_voltage_ = std::stoi(match[1].str());
  return true;
}

std::string VirtualController::unlock() {
  if (safety_mode_ != SafetyMode::protective_stop) return "Protective stop releasing";
  if (time_ - stopped_at_ < options_.unlock_delay)
    return "Cannot unlock protective stop until 5s after occurrence. Always inspect cause of protective stop before "
           "unlocking";
  safety_mode_ = SafetyMode::normal;
  return "Protective stop releasing";
}

std::string VirtualController::power_on() {
  if (is_emergency(safety_mode_)) return "Cannot power on the robot: emergency stop";
  if (robot_mode_ == RobotMode::power_off && next_mode_ == RobotMode::power_off) {
    next_mode_ = RobotMode::power_on;
    mode_at_ = time_ + kPowerTime;
  }
  return "Powering on";
}

std::string VirtualController::release_brakes() {
  if (safety_mode_ != SafetyMode::normal) return "Brake release refused";
  if (robot_mode_ == RobotMode::idle) {
    next_mode_ = RobotMode::running;
    mode_at_ = time_ + kBrakeTime;
  }
  return "Brake releasing";
}

std::string VirtualController::dashboard(std::string_view line) {
  const auto needs_remote = [this](auto action) -> std::string {
    if (!remote_) return "Command is not allowed due to safety reasons: the robot is not in remote control";
    return action();
  };
  if (line == "PolyscopeVersion") return "URSoftware 5.11.1.108318 (Dec 15 2021)";
  if (line == "get serial number") return "20225500001";
  if (line == "get robot model") return "UR5";
  if (line == "is in remote control") return remote_ ? "true" : "false";
  if (line == "robotmode") return "Robotmode: " + std::string(name_of(robot_mode_));
  if (line == "safetystatus" || line == "safetymode")
    return (line == "safetystatus" ? "Safetystatus: " : "Safetymode: ") + std::string(name_of(safety_mode_));
  if (line == "programState") return program_ ? "PLAYING " + std::string(program_->name()) : "STOPPED <unnamed>";
  if (line == "running") return program_ ? "Program running: true" : "Program running: false";
  if (line == "power on") return needs_remote([this] { return power_on(); });
  if (line == "brake release") return needs_remote([this] { return release_brakes(); });
  if (line == "unlock protective stop") return needs_remote([this] { return unlock(); });
  if (line == "power off")
    return needs_remote([this] {
      power_off();
      return std::string("Powering off");
    });
  if (line == "stop")
    return needs_remote([this] {
      stop_program();
      return std::string("Stopped");
    });
  if (line == "close safety popup") return "closing safety popup";
  if (line == "close popup") return "closing popup";
  if (line.starts_with("popup")) return "showing popup";
  return "could not understand: '" + std::string(line) + "'";
}

}  // namespace mrroc::sim::ur
