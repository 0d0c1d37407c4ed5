#include "sim/ur/program.hpp"

#include <regex>
#include <stdexcept>

#include "drivers/ur/command.hpp"
#include "drivers/ur/robot_state.hpp"
#include "sim/ur/single_command.hpp"

namespace mrroc::sim::ur {
namespace {

using mrroc::ur::ControlMode;
using mrroc::ur::ScriptState;

Six six_of(const Registers& registers, std::size_t first) {
  Six values{};
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = registers.real_inputs[first + i];
  return values;
}

/// The number in the first match of `pattern`, which has one group. Every repetition is bounded: std::regex needs stack
/// for each character that one matches.
double number_in(const std::string& text, const std::string& pattern) {
  std::smatch match;
  if (!std::regex_search(text, match, std::regex(pattern)))
    throw std::invalid_argument("the program has no " + pattern);
  return std::stod(match[1].str());
}

std::size_t register_in(const std::string& text, const std::string& pattern, int needed) {
  const double number = number_in(text, pattern);
  if (number < 0 || number + needed > kRegisters) throw std::invalid_argument("registers beyond the last one");
  return static_cast<std::size_t>(number);
}

/// drivers/ur/control.script.
class MrrocControl : public Program {
 public:
  explicit MrrocControl(const std::string& text)
      : integers_(register_in(text, "number = read_input_integer_register\\((\\d{1,9})\\)", 3)),
        reals_(register_in(text, "read_input_float_register\\((\\d{1,9})\\)", 12)),
        watchdog_(static_cast<int>(number_in(text, "silent > (\\d{1,9})\\b"))),
        speed_acceleration_(number_in(text, "speedj\\(velocities\\(\\), ([0-9.e+]{1,24})[,)]")),
        stop_acceleration_(number_in(text, "stopj\\(([0-9.e+]{1,24})\\)")),
        program_(static_cast<std::int32_t>(
            number_in(text, "write_output_integer_register\\(" + std::to_string(integers_ + 2) + ", (\\d{1,9})\\)"))) {}

  std::string_view name() const override { return "mrroc_control"; }

  bool step(ProgramSurroundings& around) override {
    if (!started_) start(around);
    const std::int32_t number = around.registers.integer_inputs[integers_];
    silent_ = number == number_ ? silent_ + 1 : 0;
    number_ = number;
    around.registers.integer_outputs[integers_ + 1] = number;
    if (ending_) return finish(around);
    const auto mode = static_cast<ControlMode>(around.registers.integer_inputs[integers_ + 1]);
    if (silent_ > watchdog_) {
      ending_ = true;
      report(around, ScriptState::stopping);
      around.motion.stopj(stop_acceleration_, around.plant);
    } else if (mode == ControlMode::position) {
      report(around, ScriptState::following_position);
      around.motion.servoj(six_of(around.registers, reals_));
    } else if (mode == ControlMode::velocity) {
      report(around, ScriptState::following_velocity);
      around.motion.speedj(six_of(around.registers, reals_ + 6), speed_acceleration_);
    } else if (previous_ != ControlMode::hold) {
      report(around, ScriptState::stopping);
      around.motion.stopj(stop_acceleration_, around.plant);
    } else if (!around.motion.is_moving()) {
      report(around, ScriptState::holding);
    }
    previous_ = mode;
    return true;
  }

 private:
  void start(ProgramSurroundings& around) {
    started_ = true;
    number_ = around.registers.integer_inputs[integers_];
    around.registers.integer_outputs[integers_ + 2] = program_;
    report(around, ScriptState::holding);
  }

  bool finish(ProgramSurroundings& around) const {
    if (around.motion.is_moving()) return true;
    report(around, ScriptState::ended);
    return false;
  }

  void report(ProgramSurroundings& around, ScriptState state) const {
    around.registers.integer_outputs[integers_] = static_cast<std::int32_t>(state);
  }

  std::size_t integers_, reals_;
  int watchdog_;
  double speed_acceleration_, stop_acceleration_;
  std::int32_t program_;
  std::int32_t number_ = 0;
  int silent_ = 0;
  bool started_ = false, ending_ = false;
  ControlMode previous_ = ControlMode::hold;
};

/// The script of ur_rtde 1.6, as its client uses it: a number of a command in input integer register 0, arguments in
/// the input double registers, the state in output integer register 0.
class UrRtdeControl : public Program {
 public:
  /// With the upper range of registers every register is 24 higher.
  explicit UrRtdeControl(const std::string& text)
      : offset_(static_cast<std::size_t>(number_in(text, "reg_offset_int = [^\\n]*?\\n?\\s*(0|24)"))) {}

  std::string_view name() const override { return "rtde_control"; }

  bool step(ProgramSurroundings& around) override {
    const std::int32_t command = around.registers.integer_inputs[offset_];
    std::int32_t& state = around.registers.integer_outputs[offset_];
    if (command == kStopScript) return false;
    if (moving_) {  // a command that lasts
      keep_following(around);
      if (around.motion.is_moving()) return true;
      moving_ = false;
      state = kDone;
      return true;
    }
    if (command == kNone) {
      executed_ = false;
      state = kReady;
    } else if (command == kServoj || command == kSpeedj) {
      follows_ = command;
      take_arguments(around, command);
      state = kReady;
    } else if (!executed_) {
      executed_ = true;
      begin(around, command);
      moving_ = around.motion.is_moving();
      state = moving_ ? kBusy : kDone;
    }
    keep_following(around);
    return true;
  }

 private:
  enum : std::int32_t { kBusy = 0, kReady = 1, kDone = 2 };
  enum : std::int32_t {
    kNone = 0,
    kMovej = 1,
    kSpeedj = 9,
    kServoj = 11,
    kSpeedStop = 15,
    kServoStop = 16,
    kStopj = 34,
    kStopScript = 255
  };

  void take_arguments(ProgramSurroundings& around, std::int32_t command) {
    target_ = six_of(around.registers, offset_);
    acceleration_ = command == kSpeedj ? around.registers.real_inputs[offset_ + 6] : 0;
  }

  /// servoj and speedj continue until their stop.
  void keep_following(ProgramSurroundings& around) {
    if (follows_ == kServoj) around.motion.servoj(target_);
    if (follows_ == kSpeedj) around.motion.speedj(target_, acceleration_);
  }

  void begin(ProgramSurroundings& around, std::int32_t command) {
    const auto& reals = around.registers.real_inputs;
    follows_ = kNone;
    if (command == kMovej)
      around.motion.movej(six_of(around.registers, offset_), reals[offset_ + 6], reals[offset_ + 7], around.plant);
    if (command == kSpeedStop || command == kServoStop || command == kStopj)
      around.motion.stopj(reals[offset_], around.plant);
  }

  std::size_t offset_;
  std::int32_t follows_ = kNone;
  Six target_{};
  double acceleration_ = 0;
  bool executed_ = false, moving_ = false;
};

/// A program that is not recognised.
class OtherProgram : public Program {
 public:
  explicit OtherProgram(std::string name) : name_(std::move(name)) {}
  std::string_view name() const override { return name_; }
  bool step(ProgramSurroundings&) override { return ++steps_ < kSteps; }

 private:
  static constexpr int kSteps = 50;
  std::string name_;
  int steps_ = 0;
};

}  // namespace

std::unique_ptr<Program> make_program(const std::string& text) {
  if (auto command = make_single_command(text)) return command;
  std::smatch match;
  if (!std::regex_search(text, match, std::regex("(?:^|\\n)def\\s{1,9}(\\w{1,99})\\s{0,9}\\(")))
    throw std::invalid_argument("the text defines no function");
  const std::string name = match[1].str();
  if (name == "mrroc_control") return std::make_unique<MrrocControl>(text);
  if (name == "rtde_control") return std::make_unique<UrRtdeControl>(text);
  return std::make_unique<OtherProgram>(name);
}

}  // namespace mrroc::sim::ur
