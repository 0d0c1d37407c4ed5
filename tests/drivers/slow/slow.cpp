#include <cmath>

#include "drivers/loopback/loopback_hardware.hpp"
#include "edp/driver.hpp"

namespace mrroc {
namespace {

class Slow final : public edp::LoopbackHardware {
 public:
  explicit Slow(const edp::DriverContext& context)
      : LoopbackHardware(context.model, context.servo_period, context.robot.synchronised),
        time_(static_cast<Tick>(std::lround(context.robot.driver.number("power_time") / context.servo_period))),
        fault_(static_cast<Tick>(context.robot.driver.number("fault_tick"))) {}

  void enable(bool on) noexcept override {
    waits_ = on;
    if (on)
      ready_ = now_ + time_;
    else
      LoopbackHardware::enable(false);
  }
  bool busy() const noexcept override { return now_ < ready_; }
  void reset_fault() noexcept override {
    fault_ = 0;
    ready_ = now_ + time_;
  }
  void read(Tick tick, edp::HardwareInput& input) noexcept override {
    now_ = tick;
    if (waits_ && !busy()) {
      waits_ = false;
      LoopbackHardware::enable(true);
    }
    LoopbackHardware::read(tick, input);
    if (fault_ != 0 && tick >= fault_) input.fault = ErrorCode::drive_fault;
  }

 private:
  const Tick time_;
  Tick fault_, now_ = 0, ready_ = 0;
  bool waits_ = false;  // for power
};

std::unique_ptr<edp::Hardware> make(const edp::DriverContext& context) { return std::make_unique<Slow>(context); }

}  // namespace
}  // namespace mrroc

MRROC_DRIVER(mrroc::make)
