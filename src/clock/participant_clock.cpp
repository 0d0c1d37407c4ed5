#include "clock/participant_clock.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <utility>

#include "clock/monotonic.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::clock {

ParticipantClock::ParticipantClock(MappedClock memory, std::uint32_t index)
    : memory_(std::move(memory)),
      index_(index),
      host_process_(static_cast<int>(::syscall(SYS_pidfd_open, memory_->host_pid, 0))) {
  if (host_process_ < 0) throw SystemError(ErrorCode::clock_lost, "clock: its host has died before the start");
}

ParticipantClock::~ParticipantClock() {
  leave();
  ::close(host_process_);
}

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
    // in slices: a host that is killed opens no gate
    const std::int64_t slice = std::min(deadline_ns, monotonic_ns() + kSecond);
    if (gate.sleep(seen, slice)) break;
    if (slice == deadline_ns) return true;
    if (!host_alive()) gate.interrupt();
  }
  if (!gate.interrupted()) return true;
  leave();
  return false;
}

void ParticipantClock::leave() noexcept {
  Membership alive = Membership::alive;
  if (slot().membership.compare_exchange_strong(alive, Membership::left)) memory().host.open();
}

void ParticipantClock::look_for_host() noexcept {
  const std::int64_t now = monotonic_ns();
  if (now < next_look_ns_) return;
  next_look_ns_ = now + kSecond;
  if (!host_alive()) slot().gate.interrupt();
}

/// One that is stopped dies of nothing, and whoever has started it may not be able to kill it, over ssh.
bool ParticipantClock::host_alive() const noexcept {
  pollfd host{host_process_, POLLIN, 0};
  if (::poll(&host, 1, 0) != 0) return false;
  const std::int64_t beat = memory_->host_beat_ns.load();
  return beat == 0 || monotonic_ns() - beat < kPatienceWithHost;
}

}  // namespace mrroc::clock
