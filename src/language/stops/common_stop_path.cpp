#include "language/stops/common_stop_path.hpp"

#include <algorithm>

namespace mrroc {

void CommonStopPath::plan(const DesiredState& from, const CommonStop& stop, double period) noexcept {
  from_ = from;
  ticks_ = stop.ticks;
  duration_ = ticks_ * period;
  k_ = std::clamp(2 + stop.rate * duration_, -1.0, 5.0);
  bend_ = from.acceleration - (k_ - 2) / duration_ * from.velocity;
}

DesiredState CommonStopPath::at(double t) const noexcept {
  const double s = t / duration_;
  if (!(s < 1)) return end();
  const double own = duration_ * s * (1 + s * ((k_ - 2) / 2 + s * ((1 - 2 * k_) / 3 + s * k_ / 4)));
  const double speed = (1 - s) * (1 - s) * (1 + k_ * s);
  const double change = (1 - s) * (k_ - 2 - 3 * k_ * s) / duration_;
  const JointVector velocity = from_.velocity + own * bend_;
  return {position_at(own), speed * velocity, change * velocity + speed * speed * bend_};
}

}  // namespace mrroc
