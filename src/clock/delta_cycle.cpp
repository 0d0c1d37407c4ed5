#include "clock/delta_cycle.hpp"

#include <algorithm>
#include <exception>

#include "clock/wall/monotonic.hpp"

namespace mrroc::clock {

namespace {

/// Names of the participants for which `pred` holds, "a, b".
template <class Predicate>
std::string names(const ClockMemory& memory, Predicate pred) {
  std::string text;
  for (std::uint32_t i = 0; i < memory.participant_count; ++i)
    if (pred(memory.participants[i], i))
      text += (text.empty() ? "" : ", ") + std::string(memory.participants[i].name.view());
  return text;
}

bool alive(const ParticipantSlot& slot) { return slot.membership.load() == Membership::alive; }

}  // namespace

void DeltaCycle::run() {
  while (await_quiescence() && counts_agree()) {
    if (open_delta(Who::anybody)) continue;
    if (dead_end()) continue;
    if (wait_for_next_tick()) begin_next_tick();
  }
}

bool DeltaCycle::await_quiescence() {
  for (;;) {
    seen_ = memory_.host.word();
    if (memory_.state.load() != State::running) return false;
    if (quiescent(memory_)) return true;
    memory_.host.sleep(seen_, kForever);
  }
}

bool DeltaCycle::counts_agree() {
  for (std::uint32_t i = 0; i < memory_.link_count.load(); ++i) {
    const LinkEntry& link = memory_.links[i];
    const std::uint64_t arrived = link.arrived.load();
    const std::uint64_t sent = link.sent.load();
    if (arrived <= sent || !live(memory_, link)) continue;
    fail(memory_, "topic " + std::string(link.topic.view()) + ": " + std::to_string(arrived) + " messages arrived, " +
                      std::to_string(sent) + " were sent: one was not counted, or arrived twice");
    return false;
  }
  return true;
}

bool DeltaCycle::open_delta(Who caller) {
  const bool physics = caller == Who::physics;
  const Tick tick = physics ? next_tick_ : memory_.tick.load();
  const Tick end = physics ? next_tick_ + 1 : next_tick_;  // wake ticks before it have come
  // messages sent in the new delta must not count as seen: read all counts before a process can stamp one
  std::array<std::uint64_t, kMaxParticipants> mail{};
  std::array<bool, kMaxParticipants> due{};
  bool any = false;
  for (std::uint32_t i = 0; i < memory_.participant_count; ++i) {
    const ParticipantSlot& slot = memory_.participants[i];
    if (!alive(slot)) continue;
    mail[i] = slot.mail.load();
    const bool tick_due = slot.wake_tick.load() < end;
    due[i] = physics ? tick_due && slot.part.load() == Part::world : tick_due || mail[i] != seen_mail_[i];
    any = any || due[i];
  }
  if (!any) return false;
  if (++deltas_in_tick_ > delta_limit_) {
    fail_zero_time_loop();
    return true;
  }
  const std::uint64_t delta = memory_.delta.load() + 1;
  memory_.delta.store(delta);
  for (std::uint32_t i = 0; i < memory_.participant_count; ++i) {
    if (!due[i]) continue;
    ParticipantSlot& slot = memory_.participants[i];
    slot.reason.store(slot.wake_tick.load() < end ? Wake::tick : Wake::mail);
    slot.tick.store(tick);
    slot.delta.store(delta);
    slot.running.store(1);
    seen_mail_[i] = mail[i];
    last_delta_[i] = delta;
  }
  for (std::uint32_t i = 0; i < memory_.participant_count; ++i)
    if (due[i]) memory_.participants[i].gate.open();
  return true;
}

bool DeltaCycle::dead_end() {
  bool anybody = false;
  for (std::uint32_t i = 0; i < memory_.participant_count; ++i) {
    const ParticipantSlot& slot = memory_.participants[i];
    if (!alive(slot)) continue;
    if (slot.wake_tick.load() != kNever) return false;
    anybody = true;
  }
  if (events_.next() != kNever) return false;
  if (live_operator_ && memory_.mode == Mode::paced) return false;  // time passes while the operator decides
  if (anybody && !live_operator_)
    fail_dead_end();
  else
    memory_.host.sleep(seen_, kForever);
  return true;
}

bool DeltaCycle::wait_for_next_tick() {
  if (memory_.mode != Mode::paced) return true;
  const std::int64_t due = begin_of(memory_, next_tick_);
  if (first_look_ && next_tick_ > 0 && monotonic_ns() >= due) late_ticks_.fetch_add(1);
  first_look_ = false;
  // an opened gate means mail from the operator, or the end: check the table before the tick begins
  return !memory_.host.sleep(seen_, due);
}

void DeltaCycle::begin_next_tick() {
  first_look_ = true;
  try {
    events_.run(next_tick_);
  } catch (const std::exception& error) {
    fail(memory_, "event at tick " + std::to_string(next_tick_) + ": " + error.what());
  }
  if (!await_quiescence()) return;
  deltas_in_tick_ = 0;
  if (open_delta(Who::physics) && !await_quiescence()) return;
  memory_.tick.store(next_tick_);
  ++next_tick_;
}

void DeltaCycle::fail_zero_time_loop() {
  const std::uint64_t window = std::min<std::uint64_t>(kMaxParticipants, delta_limit_ / 2);
  const std::uint64_t newest = memory_.delta.load();
  const std::string processes =
      names(memory_, [&](const ParticipantSlot&, std::uint32_t i) { return last_delta_[i] + window > newest; });
  fail(memory_, "zero-time loop at tick " + std::to_string(memory_.tick.load()) + " between " + processes + ": " +
                    std::to_string(delta_limit_) + " deltas");
}

void DeltaCycle::fail_dead_end() {
  const auto those = [this](Membership membership) {
    return names(memory_, [membership](const ParticipantSlot& slot, std::uint32_t) {
      return slot.membership.load() == membership;
    });
  };
  std::string text = "nothing can happen any more at tick " + std::to_string(memory_.tick.load()) + ": " +
                     those(Membership::alive) + " waiting for mail that no process can send";
  const std::string left = those(Membership::left);
  const std::string dead = those(Membership::dead);
  if (!left.empty()) text += "; ended: " + left;
  if (!dead.empty()) text += "; died: " + dead;
  fail(memory_, text);
}

std::string describe(const ClockMemory& memory) {
  static constexpr std::array<const char*, 4> kStates = {"setting up", "running", "failed", "ended"};
  const State state = memory.state.load();
  std::string text = kStates.at(static_cast<std::size_t>(state));
  if (state == State::failed) return text + ": " + std::string(memory.error.view());
  if (state == State::setting_up) {
    const std::string missing =
        names(memory, [](const ParticipantSlot& slot, std::uint32_t) { return slot.ready.load() == 0; });
    return text + (missing.empty() ? ", all are ready" : ", not ready: " + missing);
  }
  if (memory.mode == Mode::real)
    text += " at tick " + std::to_string(wall_tick(memory));
  else
    text += " at tick " + std::to_string(memory.tick.load()) + ", delta " + std::to_string(memory.delta.load());
  const std::string busy =
      names(memory, [](const ParticipantSlot& slot, std::uint32_t) { return alive(slot) && slot.running.load() != 0; });
  if (!busy.empty()) text += "; at work: " + busy;
  for (std::uint32_t i = 0; i < memory.link_count.load(); ++i) {
    const LinkEntry& link = memory.links[i];
    const std::uint64_t arrived = link.arrived.load();
    const std::uint64_t sent = link.sent.load();
    if (sent > arrived && live(memory, link))
      text += "; in flight on " + std::string(link.topic.view()) + " to " +
              std::string(memory.participants[link.receiver].name.view()) + ": " + std::to_string(sent - arrived);
  }
  return text;
}

}  // namespace mrroc::clock
