#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "drivers/ur/robot_state.hpp"
#include "drivers/ur/rtde/messages.hpp"
#include "drivers/ur/rtde/value.hpp"
#include "drivers/ur/terminals.hpp"
#include "mrroc/signals.hpp"
#include "sim/ur/program.hpp"
#include "sim/ur/program_settings.hpp"

namespace mrroc::sim::ur {

using mrroc::ur::JointMode;
using mrroc::ur::RobotMode;
using mrroc::ur::RuntimeState;
using mrroc::ur::SafetyMode;

/// The state of a UR controller without its servers: power, safety, the running program, registers, terminals, and the
/// arm. It is written from the manuals (RTDE guide, dashboard server) of an e-Series with PolyScope 5.11. One thread.
///
/// Simplified: power and brakes take kPowerTime and kBrakeTime instead of some ten seconds; currents and the
/// accelerometer are zero; temperatures and voltages are constant; the speed slider does not slow programs down; a
/// protective stop comes on command only. The wrench is that of a sensor in the flange, on a CB3 as well.
class VirtualController {
 public:
  struct Options {
    double period = 0.002;                             ///< s
    double unlock_delay = 5;                           ///< s, until a protective stop can be released
    bool powered = false;                              ///< at the start the arm has power and its brakes are released
    int tool_terminals = mrroc::ur::kNoToolTerminals;  ///< numbers in the plant's wiring of those of the tool
    mrroc::ur::rtde::ControllerVersion version{5, 11, 1, 108318};
  };
  VirtualController(Options options, std::unique_ptr<JointPlant> plant);

  /// Measures the joints and the inputs before the period: what packages report in lockstep.
  void measure();
  /// One period.
  void step();
  /// The time of a new period without the arm's: it boots.
  void restart();

  // RTDE
  using Getter = std::function<mrroc::ur::rtde::Value()>;
  using Setter = std::function<void(const mrroc::ur::rtde::Value&)>;
  struct Input {
    mrroc::ur::rtde::FieldType type;
    Setter set;
  };
  /// Null: it has no such field.
  const Getter* output(const std::string& name) const;
  const Input* input(const std::string& name) const;
  const mrroc::ur::rtde::ControllerVersion& version() const noexcept { return options_.version; }

  // the other servers
  /// The answer to a line of the dashboard server, without its line end.
  std::string dashboard(std::string_view line);
  /// Starts the program of this text. False: no remote control, no power, or it is not a program.
  bool start_program(const std::string& text);
  /// Name of the running program; empty: none.
  std::string_view program() const noexcept { return program_ ? program_->name() : std::string_view{}; }

  // the teach pendant, the safety system, the wiring
  void set_remote_control(bool on) noexcept { remote_ = on; }
  void protective_stop() noexcept;
  void emergency_stop(bool pressed) noexcept;
  void safeguard_stop(bool open) noexcept;
  void power_off() noexcept;
  void fail_joint(std::size_t axis) noexcept;
  void stop_program() noexcept;
  /// Adds `error` (rad, or NaN) to the measured position of the first joint; 0: measures right again.
  void falsify(double error) noexcept { false_by_ = error; }
  /// Where nothing is wired to the inputs.
  void set_inputs(std::uint64_t digital, double analog0, double analog1) noexcept;

  RobotMode robot_mode() const noexcept { return robot_mode_; }
  SafetyMode safety_mode() const noexcept { return safety_mode_; }
  RuntimeState runtime() const noexcept { return program_ ? RuntimeState::playing : RuntimeState::stopped; }
  double time() const noexcept { return time_; }
  Six position() const { return plant_->position(); }
  Six velocity() const { return plant_->velocity(); }
  const Registers& registers() const noexcept { return registers_; }
  std::uint64_t digital_outputs() const noexcept { return digital_outputs_; }
  double analog_output(std::size_t i) const noexcept { return analog_outputs_[i]; }
  double speed_slider() const noexcept { return speed_slider_; }
  std::uint64_t digital_inputs() const noexcept { return digital_inputs_; }
  double analog_input(std::size_t i) const noexcept { return analog_inputs_[i]; }
  double payload() const noexcept { return settings_.payload; }
  const Eigen::Vector3d& payload_centre() const noexcept { return settings_.payload_centre; }
  int tool_voltage() const noexcept { return settings_.tool_voltage; }
  double period() const noexcept { return options_.period; }
  const JointTargets& targets() const noexcept { return targets_; }

  // controller_wrench.cpp
  /// actual_TCP_pose and tcp_offset: m and rotation vector, in the base and in the flange frame.
  Six tool_pose() const;
  Six tool_offset() const;
  /// actual_TCP_force: the wrench of the environment on the tool, in the axes of the base frame, about the flange's
  /// origin; of a CB3 about the tool's. The payload's weight is taken out, gravity being along -z of the base frame.
  Six tool_force() const;
  /// ft_raw_wrench: the load on the flange, in its frame.
  Six flange_load() const;
  std::uint32_t robot_status() const noexcept;
  std::uint32_t safety_status() const noexcept;
  JointMode joint_mode(std::size_t axis) const noexcept;

 private:
  bool emergency() const noexcept {
    return safety_mode_ == SafetyMode::robot_emergency_stop || safety_mode_ == SafetyMode::system_emergency_stop;
  }
  void fill_outputs();
  void fill_inputs();
  void advance_power() noexcept;
  void run_program();
  void exchange_terminals();
  void halt(SafetyMode mode) noexcept;
  std::string unlock();
  std::string power_on();
  std::string release_brakes();

  static constexpr double kPowerTime = 0.1, kBrakeTime = 0.1, kBootTime = 0.2;  // s

  const Options options_;
  std::unique_ptr<JointPlant> plant_;
  ArmMotion motion_;
  JointTargets targets_;
  Registers registers_;
  std::unique_ptr<Program> program_;
  std::map<std::string, Getter> outputs_;
  std::map<std::string, Input> inputs_;

  double time_ = 0;
  std::uint64_t periods_ = 0;
  RobotMode robot_mode_ = RobotMode::power_off;
  RobotMode next_mode_ = RobotMode::power_off;  ///< reached at `mode_at_`
  double mode_at_ = 0;
  SafetyMode safety_mode_ = SafetyMode::normal;
  double stopped_at_ = 0;  ///< of the protective stop
  bool remote_ = true;
  std::optional<std::size_t> failed_joint_;
  double false_by_ = 0;  ///< rad
  std::uint64_t digital_inputs_ = 0, digital_outputs_ = 0;
  std::array<double, 4> analog_inputs_{};   ///< V; 2 and 3 are those of the tool
  std::array<double, 2> analog_outputs_{};  ///< V
  double speed_slider_ = 1;
  ProgramSettings settings_;
  // outputs are written under masks: each package has the mask before the values
  std::uint8_t standard_mask_ = 0, configurable_mask_ = 0, tool_mask_ = 0, analog_mask_ = 0;
  std::uint32_t slider_mask_ = 0;
};

}  // namespace mrroc::sim::ur
