#include "drivers/ur/ur_hardware.hpp"
#include "edp/driver.hpp"

namespace mrroc {
namespace {

/// A good clock, and one defect between it and the servo.
class BadClock final : public edp::RobotClock {
 public:
  BadClock(edp::RobotClock& good, std::string defect) : good_(good), defect_(std::move(defect)) {}

  double period() const noexcept override { return good_.period(); }
  bool wait(std::int64_t deadline, edp::Beat& beat) noexcept override {
    if (is("repeats") && ++waits_ % 3 == 0) {
      beat = last_;
      return true;
    }
    const std::int64_t early = is("gives_up_early") ? kEarly : 0;
    const bool came = good_.wait(deadline - early, beat) && !silent_;
    silent_ = silent_ || (is("stays_silent") && !came);
    if (came) last_ = beat;
    return came;
  }
  edp::BeatCounters counters() const noexcept override {
    edp::BeatCounters counters = good_.counters();
    if (is("does_not_count")) counters.lost = counters.doubled = counters.late = 0;
    return counters;
  }

 private:
  bool is(const char* defect) const noexcept { return defect_ == defect; }

  static constexpr std::int64_t kEarly = 2'000'000;  // ns
  edp::RobotClock& good_;
  std::string defect_;
  edp::Beat last_;
  int waits_ = 0;
  bool silent_ = false;
};

class BadUr final : public ur::UrHardware {
 public:
  BadUr(const ur::UrOptions& options, const edp::DriverContext& context)
      : UrHardware(options, context.model, context.servo_period),
        clock_(*UrHardware::clock(), context.robot.driver.text("defect")) {}
  edp::RobotClock* clock() noexcept override { return &clock_; }

 private:
  BadClock clock_;
};

std::unique_ptr<edp::Hardware> make(const edp::DriverContext& context) {
  const config::DriverEntry& keys = context.robot.driver;
  const auto integer = [&keys](const char* key) { return static_cast<int>(keys.number(key)); };
  ur::UrOptions options;
  options.address = keys.text("address");
  options.rtde_port = integer("rtde_port");
  options.dashboard_port = integer("dashboard_port");
  options.script_port = integer("script_port");
  options.missed_max = integer("missed_max");
  options.timeout = keys.number("timeout");
  options.watchdog = keys.number("watchdog");
  options.script = keys.text("script");
  return std::make_unique<BadUr>(options, context);
}

}  // namespace
}  // namespace mrroc

MRROC_DRIVER(mrroc::make)
