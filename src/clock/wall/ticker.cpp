#include "clock/wall/ticker.hpp"

#include <cerrno>

#include "clock/wall/monotonic.hpp"

namespace mrroc::clock {

Ticker::Ticker(std::int64_t epoch_ns, std::int64_t period_ns) noexcept : epoch_ns_(epoch_ns), period_ns_(period_ns) {
  const std::int64_t since = monotonic_ns() - epoch_ns;
  next_ = since <= 0 ? 0 : static_cast<Tick>(since / period_ns) + 1;
}

Tick Ticker::wait_next() noexcept {
  statistics_.end(monotonic_ns());
  const timespec due = to_timespec(begin_of(next_));
  while (::clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &due, nullptr) == EINTR) {
  }
  const std::int64_t now = monotonic_ns();
  const auto present = static_cast<Tick>((now - epoch_ns_) / period_ns_);
  statistics_.begin(now, now - begin_of(present), present - next_);
  next_ = present + 1;
  return present;
}

}  // namespace mrroc::clock
