#include <algorithm>
#include <csignal>
#include <mutex>
#include <stdexcept>
#include <vector>

#include "docs/examples/stream/stream.hpp"

namespace mrroc {
namespace {

/// A good driver, and one defect between it and the servo.
class Bad final : public edp::Hardware {
 public:
  explicit Bad(const edp::DriverContext& context) : good_(context), defect_(context.robot.driver.text("defect")) {
    if (is("throws")) throw std::runtime_error("the factory fails");
  }

  void open() override {
    try {
      good_.open();
    } catch (const HardwareError&) {
      if (!is("opens_anything")) throw;
    }
  }
  void enable(bool on) noexcept override {
    if (on) ticks_ = 0;
    good_.enable(on || is("drives_without_power"));
  }
  void read(Tick tick, edp::HardwareInput& input) noexcept override {
    if (is("allocates")) memory_ = std::vector<double>(static_cast<std::size_t>(tick % 7 + 1));
    if (is("locks")) const std::lock_guard lock(mutex_);
    for (int i = 0; i < 30 && is("sleeps"); ++i) ::usleep(1);
    if (is("crashes") && tick == 30) ::raise(SIGSEGV);
    good_.read(tick, input);
    if (is("late_tick")) input.time = static_cast<double>(tick + 1);
    for (double& position : input.motors) position += is("off_the_shaft") ? 0.02 : 0;
    if (is("hides_silence")) input.fault = ErrorCode::none;
  }
  void set_points(const JointVector& position, const JointVector& velocity) noexcept override {
    const double drift = is("drifts") ? kDrift * std::max(0, 90 - std::abs(++ticks_ - 90)) : 0;
    good_.set_points(position.array() + drift, velocity);
  }
  void write(Tick tick, const JointVector& current) noexcept override {
    if (is("drives_without_power")) good_.enable(true);
    good_.write(tick, current);
  }
  void set_origin(const JointVector& shift) noexcept override {
    if (!is("no_origin")) good_.set_origin(shift);
  }

 private:
  bool is(const char* defect) const noexcept { return defect_ == defect; }

  Stream good_;
  std::string defect_;
  std::vector<double> memory_;
  std::mutex mutex_;
  static constexpr double kDrift = 0.0008;  // rad a tick, there and back
  int ticks_ = 0;
};

std::unique_ptr<edp::Hardware> make(const edp::DriverContext& context) { return std::make_unique<Bad>(context); }

}  // namespace
}  // namespace mrroc

MRROC_DRIVER(mrroc::make)
