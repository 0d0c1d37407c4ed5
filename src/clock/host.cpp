#include "clock/host.hpp"

#include <unistd.h>

#include <algorithm>
#include <exception>

#include "clock/operator_clock.hpp"
#include "clock/wall/monotonic.hpp"
#include "clock/wall/real_clock.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::clock {

namespace {

/// Between the announcement of the epoch and tick 0 in real mode: time for the processes to wake up.
constexpr std::int64_t kLeadPeriods = 10;

std::uint64_t checked_limit(std::uint64_t limit) {
  if (limit < 2)
    throw SystemError(ErrorCode::configuration,
                      "clock: delta_limit " + std::to_string(limit) + ": expected at least 2");
  return limit;
}

}  // namespace

ClockHost::ClockHost(const HostOptions& options)
    : memory_(MappedClock::create(options.mode, options.period, options.participants)),
      cycle_(*memory_, events_, checked_limit(options.delta_limit), options.live_operator) {}

ClockHost::~ClockHost() {
  end();
  join();
}

void ClockHost::join() {
  if (thread_.joinable()) thread_.join();
}

std::vector<std::string> ClockHost::not_ready() const {
  std::vector<std::string> missing;
  for (std::uint32_t i = 0; i < memory_->participant_count; ++i) {
    const ParticipantSlot& slot = memory_->participants[i];
    if (slot.ready.load() == 0 || slot.membership.load() != Membership::alive) missing.emplace_back(slot.name.view());
  }
  return missing;
}

std::vector<std::string> ClockHost::wait_ready(double timeout) {
  const std::int64_t deadline = monotonic_ns() + static_cast<std::int64_t>(timeout * 1e9);
  for (;;) {
    const std::uint32_t seen = memory_->host.word();
    std::vector<std::string> missing = not_ready();
    if (missing.empty() || state() != State::setting_up || !memory_->host.sleep(seen, deadline)) return missing;
  }
}

void ClockHost::at_tick(Tick tick, TickEvents::Callback callback) {
  events_.add(tick, std::move(callback));
  memory_->host.open();  // it may be sleeping towards a later event
}

void ClockHost::open_time(std::int64_t epoch_ns) {
  std::string missing;
  for (const std::string& name : not_ready()) missing += (missing.empty() ? "" : ", ") + name;
  if (!missing.empty()) throw SystemError(ErrorCode::process_silent, "clock: not ready for the start: " + missing);
  connect(*memory_);
  const std::int64_t lead = memory_->mode == Mode::real ? kLeadPeriods * memory_->period_ns : 0;
  const std::int64_t now = monotonic_ns();
  if (epoch_ns != 0 && epoch_ns < now)
    throw SystemError(ErrorCode::clock_lost,
                      "clock: asked to start " + std::to_string((now - epoch_ns) / 1000) + " us ago");
  if (memory_->mode != Mode::lockstep) memory_->epoch_ns.store(epoch_ns != 0 ? epoch_ns : now + lead);
  State expected = State::setting_up;
  if (!memory_->state.compare_exchange_strong(expected, State::running))
    throw SystemError(ErrorCode::clock_lost, "clock: cannot start: " + describe());
  if (memory_->mode == Mode::real)
    for (std::uint32_t i = 0; i < memory_->participant_count; ++i) memory_->participants[i].gate.open();
  memory_->participants[kOperator].gate.open();
}

void ClockHost::start(std::int64_t epoch_ns) {
  open_time(epoch_ns);
  thread_ = std::thread([this] { loop(); });
}

void ClockHost::run() {
  open_time(0);
  loop();
}

void ClockHost::loop() {
  if (memory_->mode == Mode::real)
    run_events_in_real_time();
  else
    cycle_.run();
}

void ClockHost::run_events_in_real_time() {
  for (;;) {
    const std::uint32_t seen = memory_->host.word();
    if (state() != State::running) return;
    const Tick next = events_.next();
    if (memory_->host.sleep(seen, begin_of(*memory_, next))) continue;
    try {
      events_.run(std::max(next, tick()));
    } catch (const std::exception& error) {
      fail("event at tick " + std::to_string(next) + ": " + error.what());
    }
  }
}

void ClockHost::participant_died(std::string_view name) {
  for (std::uint32_t i = 0; i < memory_->participant_count; ++i) {
    ParticipantSlot& slot = memory_->participants[i];
    if (slot.name.view() != name) continue;
    Membership alive = Membership::alive;
    if (slot.membership.compare_exchange_strong(alive, Membership::dead)) end_task(*memory_);
    memory_->host.open();
    return;
  }
  throw SystemError(ErrorCode::configuration, "clock: '" + std::string(name) + "' is not a participant");
}

bool ClockHost::has_left(std::string_view name) const noexcept {
  for (std::uint32_t i = 0; i < memory_->participant_count; ++i) {
    const ParticipantSlot& slot = memory_->participants[i];
    if (slot.name.view() == name) return slot.membership.load() != Membership::alive;
  }
  return true;
}

void ClockHost::fail(std::string_view text) { clock::fail(*memory_, text); }

bool ClockHost::failed_with(std::string_view name) const noexcept {
  if (state() != State::failed) return false;
  for (std::uint32_t i = 0; i < memory_->participant_count; ++i)
    if (memory_->participants[i].name.view() == name) return memory_->participants[i].failed_with.load();
  return false;
}

void ClockHost::stop() { clock::stop(*memory_); }

void ClockHost::end() { clock::end(*memory_); }

std::string ClockHost::error() const {
  return state() == State::failed ? std::string(memory_->error.view()) : std::string();
}

bool ClockHost::waits_for_somebody() const noexcept {
  return memory_->mode != Mode::real && state() == State::running && !quiescent(*memory_);
}

std::vector<std::pair<std::string, std::uint64_t>> ClockHost::at_work() const {
  std::vector<std::pair<std::string, std::uint64_t>> working;
  if (memory_->mode != Mode::real || state() != State::running) return working;
  for (std::uint32_t i = 0; i < memory_->participant_count; ++i) {
    const ParticipantSlot& slot = memory_->participants[i];
    const std::uint64_t waits = slot.waits.load();
    if (waits > 0 && waits % 2 == 0 && slot.membership.load() == Membership::alive)
      working.emplace_back(slot.name.view(), waits);
  }
  return working;
}

Tick ClockHost::tick() const noexcept {
  return memory_->mode == Mode::real ? wall_tick(*memory_) : memory_->tick.load();
}

std::unique_ptr<Clock> ClockHost::operator_clock() {
  std::int32_t none = 0;
  if (!memory_->participants[kOperator].pid.compare_exchange_strong(none, ::getpid()))
    throw SystemError(ErrorCode::configuration, "clock: the host has given out its operator clock already");
  MappedClock memory = MappedClock::attach(fd());
  if (memory->mode == Mode::real) return std::make_unique<RealClock>(std::move(memory), kOperator);
  return std::make_unique<OperatorClock>(std::move(memory));
}

}  // namespace mrroc::clock
