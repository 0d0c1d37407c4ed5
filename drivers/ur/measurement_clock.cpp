#include "drivers/ur/measurement_clock.hpp"

#include <algorithm>
#include <cmath>

namespace mrroc::ur {

MeasurementClock::Measured MeasurementClock::take(double timestamp, std::int64_t received, Tick now,
                                                  std::int64_t read) noexcept {
  const auto present = static_cast<double>(now);
  const double elapsed = timestamp - timestamp_;
  const double offset = static_cast<double>(received) * 1e-9 - timestamp;
  const double grid = static_cast<double>(read) * 1e-9 - present * period_;
  const bool continues = started_ && elapsed >= 0 && elapsed < kRestart;
  timestamp_ = timestamp;
  started_ = std::isfinite(timestamp);
  offset_ = continues ? std::min(offset, offset_ + kDrift * elapsed) : offset;
  grid_ = continues ? std::min(grid, grid_) : grid;
  Measured measured;
  double ticks = started_ ? (timestamp + offset_ - grid_) / period_ : present;
  if (const double excess = ticks - (present + kLatest); excess > 0) {
    const double step = std::max({0.0, excess - kMostAhead, std::min(excess, kStep * (present - present_))});
    grid_ += step * period_;
    ticks -= step;
  }
  present_ = present;
  measured.tick = std::clamp(static_cast<Tick>(std::max(ticks, 0.0)), last_, std::max(now, last_));
  measured.rest = std::clamp(ticks - static_cast<double>(measured.tick), -kLatest, kLatest + kMostAhead);
  last_ = measured.tick;
  return measured;
}

}  // namespace mrroc::ur
