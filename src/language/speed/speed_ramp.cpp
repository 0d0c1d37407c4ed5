#include "language/speed/speed_ramp.hpp"

#include <algorithm>
#include <cmath>

namespace mrroc {

namespace {

constexpr double kBrakingShare = 0.5;  // of the change: the remainder is for pieces of different lengths

}  // namespace

TimeScale ramp(TimeScale from, double wanted, double duration, RampBounds bounds, double firmness) noexcept {
  const double h = duration, most = bounds.change * h;
  const double off = wanted - from.factor - 0.5 * h * from.rate;  // of a linear change to rate 0
  // the cubic between the ends changes its rate by 6 off / h^2 more
  if (std::abs(from.rate) <= most && 6 * std::abs(off) <= most * h) return {wanted, 0};
  const double side = off < 0 ? -1 : 1, change = kBrakingShare * bounds.change;
  // the fastest rate from which a stop at `wanted` is possible: r^2 / 2 change + h r / 2 = |off|
  const double fastest = change * (std::sqrt(0.25 * h * h + 2 * std::abs(off) / change) - 0.5 * h);
  const double rate = side * std::min(fastest, firmness * bounds.rate);
  const double step = side * (rate - from.rate) > 0 ? firmness * most : most;
  return ramp_at_rate(from, duration, std::clamp(rate, from.rate - step, from.rate + step));
}

TimeScale ramp_at_rate(TimeScale from, double duration, double rate) noexcept {
  const double factor = from.factor + 0.5 * duration * (from.rate + rate);
  if (factor >= 1) return {1, 0};
  if (factor <= 0) return {0, 0};
  return {factor, rate};
}

double own_time(TimeScale from, TimeScale to, double duration) noexcept {
  return duration * (0.5 * (from.factor + to.factor) + duration * (from.rate - to.rate) / 12);
}

}  // namespace mrroc
