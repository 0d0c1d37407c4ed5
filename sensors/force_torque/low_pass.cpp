#include "sensors/force_torque/low_pass.hpp"

#include <cmath>
#include <numbers>

namespace mrroc::vsp {

void LowPass::configure(double cutoff, double servo_period) noexcept {
  rate_ = 2 * std::numbers::pi * cutoff * servo_period;
  servo_period_ = servo_period;
  started_ = false;
}

double LowPass::delay() const noexcept { return enabled() ? servo_period_ / std::expm1(rate_) : 0; }

void LowPass::update(Tick tick, const Wrench& u) noexcept {
  if (!started_ || !enabled()) {
    y_ = u;
  } else if (tick > tick_) {
    y_ += -std::expm1(-rate_ * static_cast<double>(tick - tick_)) * (u - y_);
  } else {
    return;
  }
  started_ = true;
  tick_ = tick;
}

}  // namespace mrroc::vsp
