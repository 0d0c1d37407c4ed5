#include "edp/safety/encoder_watch.hpp"

#include <algorithm>
#include <cmath>

namespace mrroc::edp {

EncoderWatch::EncoderWatch(const RobotModel& model, double period) noexcept : count_(model.parameters().axes.size()) {
  const JointMatrix ratio = model.transmission(model.parameters().home);
  for (std::size_t i = 0; i < count_; ++i) {
    double speed = 0;
    for (std::size_t j = 0; j < count_; ++j)
      speed += std::abs(ratio(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j))) *
               model.parameters().axes[j].velocity_max;
    way_[i] = kMargin * speed * period;
  }
}

EncoderWatch::Finding EncoderWatch::check(const JointVector& motors, double time, double now) noexcept {
  Finding finding;
  if (!jumped_) ticks_ = std::max(now - time_, 1.0);
  for (std::size_t i = 0; i < count_; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    if (!std::isfinite(motors[k])) return {static_cast<int>(i), NotFinite{}};
    if (good_.size() == 0 || finding.axis >= 0) continue;
    const double jump = std::abs(motors[k] - good_[k]);
    if (jump > ticks_ * way_[i]) finding = {static_cast<int>(i), Excess{jump, ticks_ * way_[i]}};
  }
  jumped_ = finding.axis >= 0;
  if (jumped_) return finding;
  good_ = motors;
  time_ = std::max(time_, time);
  return finding;
}

}  // namespace mrroc::edp
