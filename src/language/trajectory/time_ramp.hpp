#pragma once

#include <algorithm>

#include "mrroc/time_scale.hpp"

namespace mrroc {

/// The own time of a motion that is slowed down to rest, and led on from there. Within a ramp of D seconds, x = t / D,
/// its rate is f0 + (f1 - f0) (3 x^2 - 2 x^3). One thread.
class TimeRamp {
 public:
  void set(double factor) noexcept { from_ = to_ = factor, time_ = duration_ = 0; }
  /// `duration` above 0, s of the clock.
  void lead_to(double factor, double duration) noexcept {
    from_ = scale().factor, to_ = factor, time_ = 0, duration_ = duration;
  }
  double goal() const noexcept { return to_; }
  bool over() const noexcept { return time_ >= duration_; }
  TimeScale scale() const noexcept {
    if (over()) return {to_, 0};
    const double x = time_ / duration_;
    return {from_ + (to_ - from_) * x * x * (3 - 2 * x), (to_ - from_) * 6 * x * (1 - x) / duration_};
  }
  /// Own seconds that pass in the next `step` s of the clock.
  double advance(double step) noexcept {
    const double ramp = std::min(step, std::max(0.0, duration_ - time_));
    const double before = passed();
    time_ += step;
    if (ramp <= 0) return to_ * step;
    return (over() ? duration_ * (from_ + to_) / 2 : passed()) - before + to_ * (step - ramp);
  }

 private:
  double passed() const noexcept {
    if (duration_ <= 0) return 0;
    const double x = time_ / duration_;
    return duration_ * (from_ * x + (to_ - from_) * x * x * x * (1 - x / 2));
  }

  double from_ = 1, to_ = 1, time_ = 0, duration_ = 0;
};

}  // namespace mrroc
