#include "language/joints/axis_stop.hpp"

#include <algorithm>
#include <cmath>

namespace mrroc {
namespace {

/// First positive time at which v + a t + j t^2 / 2 = 0, given that v and a have opposite signs and j opposes a.
double first_zero(double v, double a, double j) noexcept {
  return -2.0 * v / (a + std::copysign(std::sqrt(std::max(a * a - 2.0 * j * v, 0.0)), a));
}

}  // namespace

void AxisStop::plan(double p, double v, double a, double acceleration_max, double jerk_max) noexcept {
  const double coasting = v + a * std::abs(a) / (2.0 * jerk_max);
  const double direction = coasting > 0 ? -1.0 : 1.0;  // of the deceleration

  // along `direction`: the acceleration at the start, the change of velocity wanted, the peak acceleration
  const double start = a * direction;
  const double change = -v * direction;
  const double wanted_peak = std::sqrt(std::max(jerk_max * change + 0.5 * start * start, 0.0));
  const double peak = std::min(wanted_peak, acceleration_max);
  const double towards = std::abs(peak - start) / jerk_max;
  const double back = peak / jerk_max;
  const double gained = 0.5 * (start + peak) * towards + 0.5 * peak * back;
  const double at_peak = wanted_peak > acceleration_max ? std::max((change - gained) / peak, 0.0) : 0.0;

  const std::array<double, 3> times{towards, at_peak, back};
  const std::array<double, 3> jerks{std::copysign(jerk_max, peak - start) * direction, 0.0, -direction * jerk_max};
  lowest_ = highest_ = p;
  fastest_ = start < 0 && std::abs(coasting) > std::abs(v) ? coasting : v;
  double time = 0;
  double position = p, velocity = v, acceleration = a;
  if (v * coasting < 0) {  // reverses once, in the first phase
    const double t = first_zero(v, a, jerks[0]);
    const double turn = p + t * (v + t * (a / 2.0 + t * jerks[0] / 6.0));
    lowest_ = std::min(lowest_, turn);
    highest_ = std::max(highest_, turn);
  }
  for (std::size_t i = 0; i < phases_.size(); ++i) {
    phases_[i] = {time, position, velocity, acceleration, jerks[i]};
    const double t = times[i];
    position += t * (velocity + t * (acceleration / 2.0 + t * jerks[i] / 6.0));
    velocity += t * (acceleration + t * jerks[i] / 2.0);
    acceleration += t * jerks[i];
    time += t;
  }
  duration_ = time;
  end_position_ = position;
  lowest_ = std::min(lowest_, position);
  highest_ = std::max(highest_, position);
}

void AxisStop::at(double t, double& p, double& v, double& a) const noexcept {
  if (t >= duration_) {
    p = end_position_;
    v = a = 0;
    return;
  }
  const Phase& phase = t < phases_[1].begin ? phases_[0] : t < phases_[2].begin ? phases_[1] : phases_[2];
  const double s = t - phase.begin;
  p = phase.p + s * (phase.v + s * (phase.a / 2.0 + s * phase.jerk / 6.0));
  v = phase.v + s * (phase.a + s * phase.jerk / 2.0);
  a = phase.a + s * phase.jerk;
}

}  // namespace mrroc
