#include "clock/wall/peer_clock.hpp"

#include <algorithm>
#include <cstdlib>

namespace mrroc::clock {

void PeerClock::add(const RoundTrip& trip) noexcept {
  const std::int64_t on_the_way = trip.received - trip.sent - trip.held;
  if (on_the_way < 0 || trip.held < 0) return;
  // the answer left after the question had been held, half a one-way time before it arrived
  const std::int64_t half = on_the_way / 2;
  const ClockOffset offset{trip.peer - (trip.received - half), on_the_way - half};
  if (in_window_ == 0 || offset.error_ns < best_.error_ns) best_ = offset;
  if (++in_window_ == kWindow) close_window(trip.received);
}

void PeerClock::close_window(std::int64_t now) noexcept {
  in_window_ = 0;
  if (!kept_ || !first_) {
    const auto may_have_moved = static_cast<std::int64_t>(kUnsteered * static_cast<double>(now - first_at_));
    if (first_ && best_.error_ns >= first_->error_ns + may_have_moved) return;
    first_ = best_;
    first_at_ = now;
    return;
  }
  const std::int64_t change = std::abs(best_.ns - first_->ns);
  worst_drift_ = std::max(worst_drift_, change);
  certain_drift_ = std::max(certain_drift_, change - best_.error_ns - first_->error_ns);
  worst_trip_ = std::max(worst_trip_, 2 * best_.error_ns);
}

}  // namespace mrroc::clock
