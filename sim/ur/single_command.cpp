#include "sim/ur/single_command.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "drivers/ur/terminals.hpp"
#include "sim/ur/program_settings.hpp"

namespace mrroc::sim::ur {
namespace {

constexpr double kDefaultSpeed = 1.05, kDefaultAcceleration = 1.4;  // of movej, rad/s and rad/s^2
constexpr int kDigitalOutputs = 18;
constexpr double kMaxAngle = 6.34, kMaxRate = 100;  // rad; rad/s or rad/s^2

std::string name_of_command(const std::string& line) { return line.substr(0, line.find_first_of("([")); }

/// The number after "NAME=".
double named(const std::string& line, const std::string& name, double otherwise) {
  const std::size_t begin = line.find(name + "=");
  if (begin == std::string::npos) return otherwise;
  const std::vector<double> numbers = numbers_in(line.substr(begin + name.size() + 1));
  return numbers.empty() ? otherwise : numbers[0];
}

class MotionCommand : public Program {
 public:
  MotionCommand(std::string name, const std::string& line, std::vector<double> numbers)
      : name_(std::move(name)),
        numbers_(std::move(numbers)),
        speed_(named(line, "v", kDefaultSpeed)),
        acceleration_(named(line, "a", kDefaultAcceleration)) {}

  std::string_view name() const override { return name_; }

  bool step(ProgramSurroundings& around) override {
    if (started_) return around.motion.is_moving();
    started_ = true;
    Six target{};
    if (name_ == "movej") {
      std::copy_n(numbers_.begin(), target.size(), target.begin());
      around.motion.movej(target, speed_, acceleration_, around.plant);
    } else {
      around.motion.stopj(numbers_[0], around.plant);
    }
    return true;
  }

 private:
  std::string name_;
  std::vector<double> numbers_;
  double speed_, acceleration_;
  bool started_ = false;
};

/// It acts when it starts.
class SettingCommand : public Program {
 public:
  explicit SettingCommand(std::string name) : name_(std::move(name)) {}
  std::string_view name() const override { return name_; }
  bool step(ProgramSurroundings&) override { return false; }

 private:
  std::string name_;
};

}  // namespace

std::unique_ptr<Program> make_single_command(const std::string& line) {
  const std::string name = name_of_command(line);
  std::vector<double> numbers = numbers_in(line.substr(name.size()));
  const auto is_angle = [](double each) { return std::abs(each) <= kMaxAngle; };
  const auto is_rate = [](double each) { return each > 0 && each <= kMaxRate; };
  const bool moves = name == "movej" && numbers.size() >= 6 &&
                     std::all_of(numbers.begin(), numbers.begin() + 6, is_angle) &&
                     is_rate(named(line, "v", kDefaultSpeed)) && is_rate(named(line, "a", kDefaultAcceleration));
  const bool stops = (name == "stopj" || name == "stopl") && !numbers.empty() && is_rate(numbers[0]);
  if (moves || stops) return std::make_unique<MotionCommand>(name, line, std::move(numbers));
  for (const char* setting :
       {"set_digital_out", "digital_out", "set_analog_out", "set_tcp", "set_payload", "set_tool_voltage"})
    if (name == setting && !numbers.empty()) return std::make_unique<SettingCommand>(name);
  return nullptr;
}

void set_outputs_of(const std::string& line, std::uint64_t& digital, std::array<double, 2>& analog) {
  const std::string name = name_of_command(line);
  const std::vector<double> numbers = numbers_in(line.substr(name.size()));
  if (numbers.empty() || numbers[0] < 0 || numbers[0] >= kDigitalOutputs) return;
  const auto terminal = static_cast<unsigned>(numbers[0]);
  if (name == "set_digital_out" || name == "digital_out") {
    const std::uint64_t bit = std::uint64_t{1} << terminal;
    digital = line.find("True") != std::string::npos ? digital | bit : digital & ~bit;
  } else if (name == "set_analog_out" && terminal < analog.size() && numbers.size() > 1) {
    analog[terminal] = mrroc::ur::kAnalogRange * std::clamp(numbers[1], 0.0, 1.0);
  }
}

}  // namespace mrroc::sim::ur
