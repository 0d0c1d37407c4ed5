#include "clock/wall/package_clock.hpp"

#include <algorithm>
#include <cmath>

namespace mrroc::clock {

void PackageClock::start(double period) noexcept {
  period_ = period;
  started_ = false;
}

PackageClock::Verdict PackageClock::take(double timestamp, std::int64_t received) noexcept {
  const double offset = static_cast<double>(received) * 1e-9 - timestamp;
  const double elapsed = timestamp - last_;
  Verdict verdict;
  verdict.restarted = started_ && !(elapsed > -period_ / 2 && elapsed < kRestart);
  last_ = timestamp;
  if (!started_ || verdict.restarted) {
    started_ = true;
    offset_ = offset;
    return verdict;
  }
  const double periods = std::round(elapsed / period_);
  verdict.doubled = periods < 1;
  if (periods > 1) verdict.lost = static_cast<std::uint64_t>(periods) - 1;
  offset_ = std::min(offset, offset_ + kDrift * elapsed);
  verdict.late = !verdict.doubled && offset - offset_ > period_;
  return verdict;
}

}  // namespace mrroc::clock
