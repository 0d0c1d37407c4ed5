#include "clock/lockstep_clock.hpp"

#include <algorithm>

#include "clock/wall/monotonic.hpp"

namespace mrroc::clock {

bool LockstepClock::start() {
  const std::uint32_t seen = slot().gate.word();
  announce_ready();
  if (!sleep(seen, kForever)) return false;
  update_time();
  return true;
}

Wake LockstepClock::wait(Tick wake_tick) {
  const std::uint32_t seen = slot().gate.word();
  if (slot().gate.interrupted()) {
    leave();  // while it runs, so that the delta does not close in between
    return interrupted();
  }
  slot().wake_tick.store(wake_tick);
  slot().running.store(0);
  if (quiescent(memory())) memory().host.open();
  if (!sleep(seen, kForever)) return interrupted();
  update_time();
  return slot().reason.load();
}

Wake LockstepClock::interrupted() noexcept {
  const Tick now = std::min(memory().stop_tick.load(), memory().tick.load());
  tick_.store(std::max(tick_.load(), now));
  return Wake::interrupted;
}

void LockstepClock::update_time() noexcept {
  tick_.store(slot().tick.load());
  delta_.store(slot().delta.load());
}

int LockstepClock::register_sender(std::string_view topic) { return add_sender(memory(), index(), topic); }

int LockstepClock::register_receiver(std::string_view topic) { return add_link(memory(), index(), topic); }

void LockstepClock::sent(int sender) noexcept { count_sent(memory(), sender); }

void LockstepClock::arrived(int receiver) noexcept {
  // the mail first: once the link is balanced the host may close the delta and look for mail
  slot().mail.fetch_add(1);
  memory().links[static_cast<std::size_t>(receiver)].arrived.fetch_add(1);
  if (quiescent(memory())) memory().host.open();
}

}  // namespace mrroc::clock
