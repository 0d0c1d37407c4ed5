#include "clock/participant_clock.hpp"

#include <algorithm>
#include <utility>

#include "clock/wall/monotonic.hpp"

namespace mrroc::clock {

namespace {

/// Between two checks of the host. Under simulated time, which stands still without it, they may be rare.
std::int64_t check_interval(Mode mode) { return mode == Mode::real ? kSecond / 50 : kSecond; }

}  // namespace

ParticipantClock::ParticipantClock(MappedClock memory, std::uint32_t index)
    : memory_(std::move(memory)), index_(index), host_(*memory_) {}

ParticipantClock::~ParticipantClock() { leave(); }

double ParticipantClock::period() const noexcept { return static_cast<double>(memory_->period_ns) * 1e-9; }

double ParticipantClock::wall_seconds() const noexcept { return static_cast<double>(monotonic_ns()) * 1e-9; }

std::int64_t ParticipantClock::epoch_ns() const noexcept { return memory_->epoch_ns.load(); }

void ParticipantClock::interrupt() noexcept { slot().gate.interrupt(); }

void ParticipantClock::announce_ready() noexcept {
  slot().wake_tick.store(0);
  slot().ready.store(1);
  memory().host.open();
}

bool ParticipantClock::await_start() noexcept {
  for (;;) {
    const std::uint32_t seen = slot().gate.word();
    if (memory().state.load() == State::running) return true;
    if (!sleep(seen, kForever)) return false;
  }
}

bool ParticipantClock::sleep(std::uint32_t seen, std::int64_t deadline_ns) noexcept {
  Gate& gate = slot().gate;
  while (!gate.interrupted()) {
    // in slices: a host that is killed or stopped opens no gate
    const std::int64_t slice = std::min(deadline_ns, monotonic_ns() + check_interval(memory_->mode));
    if (gate.sleep(seen, slice)) break;
    if (slice == deadline_ns) return true;
    check_host();
  }
  if (!gate.interrupted()) return true;
  leave();
  return false;
}

void ParticipantClock::leave() noexcept {
  Membership alive = Membership::alive;
  if (slot().membership.compare_exchange_strong(alive, Membership::left)) memory().host.open();
}

void ParticipantClock::check_host() noexcept {
  const std::int64_t now = monotonic_ns();
  if (now < next_check_ns_) return;
  next_check_ns_ = now + check_interval(memory_->mode);
  switch (host_.poll()) {
    case HostLife::alive:
      break;
    case HostLife::stopped:
      memory_->host_was_stopped.store(1);
      clock::stop(*memory_);
      break;
    case HostLife::lost:
      slot().gate.interrupt();
      break;
  }
}

}  // namespace mrroc::clock
