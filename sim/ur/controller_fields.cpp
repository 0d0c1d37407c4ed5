// The fields of a UR controller that RTDE reads and writes: RTDE guide, tables of outputs and inputs.
#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/ur/virtual_controller.hpp"

namespace mrroc::sim::ur {
namespace {

using mrroc::ur::rtde::FieldType;
using mrroc::ur::rtde::Value;
using mrroc::ur::rtde::Vector3d;
using mrroc::ur::rtde::Vector6d;
using mrroc::ur::rtde::Vector6Int32;

void merge(std::uint64_t& bits, unsigned shift, std::uint8_t mask, std::uint8_t values) noexcept {
  const std::uint64_t all = static_cast<std::uint64_t>(mask) << shift;
  bits = (bits & ~all) | ((static_cast<std::uint64_t>(values) << shift) & all);
}

}  // namespace

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
        "joint_control_output", "actual_TCP_speed", "target_TCP_speed", "payload_inertia", "actual_current_as_torque"})
    outputs_[name] = six(0);
  outputs_["actual_TCP_pose"] = outputs_["target_TCP_pose"] = [this] { return tool_pose(); };
  outputs_["tcp_offset"] = [this] { return tool_offset(); };
  outputs_["actual_TCP_force"] = [this] { return tool_force(); };
  outputs_["ft_raw_wrench"] = [this] { return flange_load(); };
  outputs_["tcp_force_scalar"] = [this] {
    const Six force = tool_force();
    return std::hypot(force[0], force[1], force[2]);
  };
  outputs_["joint_temperatures"] = six(30);
  outputs_["actual_joint_voltage"] = six(48);
  for (const char* name : {"actual_tool_accelerometer", "elbow_position", "elbow_velocity"}) outputs_[name] = three;
  for (const char* name :
       {"actual_execution_time", "actual_momentum", "actual_robot_current", "io_current", "tool_output_current"})
    outputs_[name] = real(0);
  for (const char* name : {"actual_main_voltage", "actual_robot_voltage"}) outputs_[name] = real(48);
  outputs_["payload"] = [this] { return settings_.payload; };
  outputs_["payload_cog"] = [this] {
    const Eigen::Vector3d& centre = settings_.payload_centre;
    return Vector3d{centre[0], centre[1], centre[2]};
  };
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
  outputs_["tool_output_voltage"] = [this] { return static_cast<std::int32_t>(settings_.tool_voltage); };
  for (std::size_t i = 0; i < 2; ++i) {
    outputs_["standard_analog_input" + std::to_string(i)] = [this, i] { return analog_inputs_[i]; };
    outputs_["tool_analog_input" + std::to_string(i)] = [this, i] { return analog_inputs_[2 + i]; };
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
      if ((analog_mask_ >> i & 1) != 0) analog_outputs_[i] = mrroc::ur::kAnalogRange * std::clamp(fraction, 0.0, 1.0);
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

}  // namespace mrroc::sim::ur
