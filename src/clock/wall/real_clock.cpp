#include "clock/wall/real_clock.hpp"

#include "clock/wall/monotonic.hpp"

namespace mrroc::clock {

bool RealClock::start() {
  announce_ready();
  if (!await_start()) return false;
  seen_ = 1;  // the host's own opening; all others are mail
  slot().waits.store(2);
  return true;
}

Tick RealClock::tick() const noexcept { return wall_tick(memory()); }

Wake RealClock::wait(Tick wake_tick) {
  slot().waits.fetch_add(1);
  const Wake wake = wait_for(wake_tick);
  slot().waits.fetch_add(1);
  return wake;
}

Wake RealClock::wait_for(Tick wake_tick) {
  check_host();
  const std::int64_t deadline = begin_of(memory(), wake_tick);
  std::uint32_t word = slot().gate.word();
  if (slot().gate.interrupted()) {
    leave();
    return Wake::interrupted;
  }
  if (Gate::openings(word) == seen_ && !sleep(word, deadline)) return Wake::interrupted;
  word = slot().gate.word();
  const bool due = deadline != kForever && monotonic_ns() >= deadline;
  seen_ = Gate::openings(word);
  return due ? Wake::tick : Wake::mail;
}

void RealClock::notify() noexcept { slot().gate.open(); }

}  // namespace mrroc::clock
