#include "sim/ur/virtual_controller.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "sim/ur/single_command.hpp"

namespace mrroc::sim::ur {
VirtualController::VirtualController(Options options, std::unique_ptr<JointPlant> plant)
    : options_(options), plant_(std::move(plant)), motion_(options.period) {
  fill_outputs();
  fill_inputs();
  if (options_.powered) robot_mode_ = next_mode_ = RobotMode::running;
}

void VirtualController::step() {
  time_ = static_cast<double>(++periods_) * options_.period;
  advance_power();
  run_program();
  const bool released = robot_mode_ == RobotMode::running && !emergency();
  targets_ = released ? motion_.targets(*plant_) : JointTargets{};
  exchange_terminals();
  plant_->step(targets_, options_.period);
}

void VirtualController::measure() {
  plant_->measure();
  exchange_terminals();
}

void VirtualController::exchange_terminals() {
  ControllerIo outputs;
  outputs.digital = mrroc::ur::as_numbered(digital_outputs_, options_.tool_terminals);
  std::copy(analog_outputs_.begin(), analog_outputs_.end(), outputs.analog.begin());
  plant_->set_outputs(outputs);
  const std::optional<ControllerIo> inputs = plant_->inputs();
  if (!inputs) return;
  digital_inputs_ = mrroc::ur::as_reported(inputs->digital, options_.tool_terminals);
  std::copy_n(inputs->analog.begin(), analog_inputs_.size(), analog_inputs_.begin());
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
  } else if (emergency()) {
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
  analog_inputs_ = {analog0, analog1, 0, 0};
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
    auto program = make_program(text);
    motion_.cancel();
    program_ = std::move(program);
  } catch (const std::logic_error&) {  // of std::stod, too
    return false;
  }
  read_settings(text, settings_);
  set_outputs_of(text, digital_outputs_, analog_outputs_);
  return true;
}

}  // namespace mrroc::sim::ur
