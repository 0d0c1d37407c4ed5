#include "edp/servo/robot_ticker.hpp"

#include <algorithm>
#include <cmath>

#include "clock/wall/monotonic.hpp"

namespace mrroc::edp {

RobotTicker::RobotTicker(RobotClock& clock, std::int64_t epoch, double period) noexcept
    : clock_(clock),
      epoch_(epoch),
      period_(period * 1e9),
      beat_(std::max(clock.period() * 1e9, period_)),
      grid_(epoch, period) {}

RobotTicker::Place RobotTicker::wait_next() noexcept {
  const std::int64_t begin = clock::monotonic_ns();
  statistics_.end(begin);
  std::int64_t deadline = begin + std::llround(kSilent * beat_);
  for (;;) {
    Beat beat;
    const bool came = clock_.wait(deadline, beat);
    const std::int64_t now = clock::monotonic_ns();
    if (!came) deadline = now + std::llround(beat_);
    if (came) measured_ = grid_.place(beat);
    const double next = came ? measured_ : on_wall(now);
    if (!(next >= last_ + kLeast)) continue;
    const double beats = std::max(std::round((next - last_) * period_ / beat_), 1.0);
    statistics_.begin(now, std::llround(std::abs(on_wall(now) - next) * period_),
                      ticked_ ? static_cast<std::uint64_t>(beats) - 1 : 0);
    ticked_ = true;
    last_ = next;
    const double whole = std::floor(next);
    return {static_cast<Tick>(whole), next - whole, measured_};
  }
}

}  // namespace mrroc::edp
