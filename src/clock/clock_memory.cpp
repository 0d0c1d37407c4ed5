#include "clock/clock_memory.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <new>
#include <utility>

#include "clock/wall/monotonic.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::clock {

namespace {

[[noreturn]] void refuse(const std::string& text) { throw SystemError(ErrorCode::configuration, "clock: " + text); }

[[noreturn]] void out_of(const std::string& what) {
  throw SystemError(ErrorCode::resources, "clock: " + what + ": " + std::strerror(errno));
}

ClockMemory* map(int fd) {
  void* address = ::mmap(nullptr, sizeof(ClockMemory), PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0);
  if (address == MAP_FAILED) out_of("cannot map the clock's memory");
  return static_cast<ClockMemory*>(address);
}

void check_topic(const ClockMemory& memory, std::string_view topic) {
  if (topic.empty() || topic.size() > kTopicLength)
    refuse("topic '" + std::string(topic) + "': expected 1 to " + std::to_string(kTopicLength) + " characters");
  if (memory.state.load() != State::setting_up)
    refuse("topic '" + std::string(topic) + "' is registered after the start");
}

std::uint32_t take_entry(std::atomic<std::uint32_t>& count, std::string_view topic) {
  std::uint32_t index = count.load();
  do {
    if (index >= kMaxLinks)
      refuse("topic '" + std::string(topic) + "': the table of " + std::to_string(kMaxLinks) + " links is full");
  } while (!count.compare_exchange_weak(index, index + 1));
  return index;
}

bool close(ClockMemory& memory, State state) noexcept {
  State now = memory.state.load();
  do {
    if (now == State::failed || now == State::ended) return false;
  } while (!memory.state.compare_exchange_weak(now, state));
  for (ParticipantSlot& slot : memory.participants) slot.gate.interrupt();
  memory.host.open();
  return true;
}

}  // namespace

MappedClock MappedClock::create(Mode mode, double period, const std::vector<std::string>& participants) {
  const double period_ns = std::round(period * 1e9);
  if (!(period_ns >= 1000 && period_ns <= 1e10)) refuse("period " + std::to_string(period) + " s: expected 1e-6 to 10");
  if (participants.size() > kMaxParticipants)
    refuse(std::to_string(participants.size()) + " participants: expected at most " + std::to_string(kMaxParticipants));
  for (std::size_t i = 0; i < participants.size(); ++i) {
    if (participants[i].empty() || participants[i].size() > kNameLength)
      refuse("participant '" + participants[i] + "': expected 1 to " + std::to_string(kNameLength) + " characters");
    for (std::size_t j = 0; j < i; ++j)
      if (participants[i] == participants[j]) refuse("participant '" + participants[i] + "' is named twice");
  }
  const int fd = ::memfd_create("mrroc-clock", MFD_CLOEXEC);
  if (fd < 0) out_of("cannot create the clock's memory");
  if (::ftruncate(fd, sizeof(ClockMemory)) != 0) {
    ::close(fd);
    out_of("cannot size the clock's memory");
  }
  MappedClock mapped(map(fd), fd);
  ClockMemory& memory = *new (mapped.memory_) ClockMemory;
  memory.mode = mode;
  for (std::atomic<Tick>& tick : memory.fault_ticks) tick.store(kNever);
  memory.period_ns = static_cast<std::int64_t>(period_ns);
  memory.host_pid = ::getpid();
  memory.participant_count = static_cast<std::uint32_t>(participants.size());
  for (std::size_t i = 0; i < participants.size(); ++i)
    memory.participants[i].name = FixedText<kNameLength>(participants[i]);
  return mapped;
}

MappedClock MappedClock::attach(int fd) {
  struct stat status {};
  if (::fstat(fd, &status) != 0) out_of("descriptor " + std::to_string(fd) + " is not the clock's memory");
  if (status.st_size != static_cast<off_t>(sizeof(ClockMemory)))
    refuse("descriptor " + std::to_string(fd) + " is not this version's clock memory: " +
           std::to_string(status.st_size) + " bytes, expected " + std::to_string(sizeof(ClockMemory)));
  return MappedClock(map(fd), -1);
}

MappedClock::MappedClock(MappedClock&& other) noexcept
    : memory_(std::exchange(other.memory_, nullptr)), fd_(std::exchange(other.fd_, -1)) {}

MappedClock::~MappedClock() {
  if (memory_ != nullptr) ::munmap(memory_, sizeof(ClockMemory));
  if (fd_ >= 0) ::close(fd_);
}

std::int64_t begin_of(const ClockMemory& memory, Tick tick) noexcept {
  const std::int64_t epoch = memory.epoch_ns.load();
  const auto last = static_cast<Tick>((kForever - epoch) / memory.period_ns);
  return tick >= last ? kForever : epoch + static_cast<std::int64_t>(tick) * memory.period_ns;
}

Tick wall_tick(const ClockMemory& memory) noexcept {
  const std::int64_t epoch = memory.epoch_ns.load();
  const std::int64_t since = monotonic_ns() - epoch;
  return epoch == 0 || since < 0 ? 0 : static_cast<Tick>(since / memory.period_ns);
}

bool live(const ClockMemory& memory, const LinkEntry& link) noexcept {
  const int sender = link.sender.load();
  if (sender < 0 || link.claimed.load() == 0) return false;
  const std::uint32_t from = memory.senders[static_cast<std::size_t>(sender)].participant;
  return memory.participants[link.receiver].membership.load() == Membership::alive &&
         memory.participants[from].membership.load() != Membership::dead;
}

bool quiescent(const ClockMemory& memory) noexcept {
  for (std::uint32_t i = 0; i < memory.participant_count; ++i) {
    const ParticipantSlot& slot = memory.participants[i];
    if (slot.running.load() != 0 && slot.membership.load() == Membership::alive) return false;
  }
  const std::uint32_t count = memory.link_count.load();
  for (std::uint32_t i = 0; i < count; ++i) {
    const LinkEntry& link = memory.links[i];
    const std::uint64_t arrived = link.arrived.load();
    if (link.sent.load() > arrived && live(memory, link)) return false;
  }
  return true;
}

int add_sender(ClockMemory& memory, std::uint32_t participant, std::string_view topic) {
  check_topic(memory, topic);
  const std::uint32_t index = take_entry(memory.sender_count, topic);
  SenderEntry& entry = memory.senders[index];
  entry.topic.assign(topic);
  entry.participant = participant;
  entry.claimed.store(1);
  return static_cast<int>(index);
}

int add_link(ClockMemory& memory, std::uint32_t participant, std::string_view topic) {
  check_topic(memory, topic);
  const std::uint32_t index = take_entry(memory.link_count, topic);
  LinkEntry& entry = memory.links[index];
  entry.topic.assign(topic);
  entry.receiver = participant;
  entry.claimed.store(1);
  return static_cast<int>(index);
}

void connect(ClockMemory& memory) {
  const auto name = [&memory](const SenderEntry& entry) {
    return entry.participant == kOperator ? std::string("the operator")
                                          : std::string(memory.participants[entry.participant].name.view());
  };
  for (std::uint32_t i = 0; i < memory.sender_count.load(); ++i) {
    const SenderEntry& sender = memory.senders[i];
    if (sender.claimed.load() == 0) continue;
    for (std::uint32_t j = 0; j < i; ++j)
      if (memory.senders[j].claimed.load() != 0 && memory.senders[j].topic == sender.topic)
        refuse("topic '" + std::string(sender.topic.view()) + "' has two senders, " + name(memory.senders[j]) +
               " and " + name(sender) + ": expected one");
    for (std::uint32_t k = 0; k < memory.link_count.load(); ++k)
      if (memory.links[k].claimed.load() != 0 && memory.links[k].topic == sender.topic)
        memory.links[k].sender.store(static_cast<std::int32_t>(i));
  }
}

void count_sent(ClockMemory& memory, int sender) noexcept {
  const std::uint32_t count = memory.link_count.load();
  for (std::uint32_t i = 0; i < count; ++i)
    if (memory.links[i].sender.load() == sender) memory.links[i].sent.fetch_add(1);
}

void set_off_fault(ClockMemory& memory, std::size_t index, Tick tick) noexcept {
  Tick never = kNever;
  memory.fault_ticks[index].compare_exchange_strong(never, tick);
}

namespace {

Tick newest_tick(const ClockMemory& memory) noexcept {
  return memory.mode == Mode::real ? wall_tick(memory) : memory.tick.load();
}

}  // namespace

void end_task(ClockMemory& memory) noexcept {
  Tick never = kNever;
  memory.task_end.compare_exchange_strong(never, newest_tick(memory));
}

void stop(ClockMemory& memory) noexcept {
  if (memory.state.load() == State::setting_up) {
    end(memory);
    return;
  }
  Tick never = kNever;
  if (!memory.stop_tick.compare_exchange_strong(never, newest_tick(memory))) return;
  end_task(memory);
  for (std::uint32_t i = 0; i < memory.participant_count; ++i) {
    ParticipantSlot& slot = memory.participants[i];
    if (slot.part.load() == Part::task) {
      Membership alive = Membership::alive;
      slot.membership.compare_exchange_strong(alive, Membership::dead);  // also for one that never waits again
      slot.gate.interrupt();
    } else if (memory.mode == Mode::real) {
      slot.gate.open();  // in simulated time the next tick wakes it
    }
  }
  memory.host.open();
}

bool fail(ClockMemory& memory, std::string_view text) noexcept {
  if (memory.failing.exchange(1) != 0) return false;
  memory.error.assign(text);
  for (ParticipantSlot& slot : memory.participants) slot.failed_with.store(slot.membership.load() == Membership::alive);
  return close(memory, State::failed);
}

bool end(ClockMemory& memory) noexcept { return close(memory, State::ended); }

}  // namespace mrroc::clock
