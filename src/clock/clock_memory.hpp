#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "clock/clock.hpp"
#include "clock/emergency_stop.hpp"
#include "clock/gate.hpp"
#include "clock/group_stops.hpp"
#include "mrroc/fixed_text.hpp"
#include "mrroc/types.hpp"

namespace mrroc::clock {

/// The shared state of time of a deployment's processes: plain words in a memfd that the host creates and its children
/// inherit. It leaves no file, whichever process dies. There is no lock and hardly a word with two writers, so that a
/// process can die between any two instructions, and its own words suffice to determine its state.

enum class Mode : std::uint32_t { real, paced, lockstep };
enum class State : std::uint32_t { setting_up, running, failed, ended };

enum class Membership : std::uint32_t {
  alive,
  left,  ///< it left on its own: no process waits for it, its messages still arrive
  dead   ///< it was lost: no process waits for messages from it or to it
};

inline constexpr std::size_t kMaxParticipants = 64;
/// Slot of the runner's own links: no process waits for this sender and receiver.
inline constexpr std::uint32_t kOperator = kMaxParticipants;
inline constexpr std::uint32_t kMaxLinks = 2048;
inline constexpr std::size_t kTopicLength = 95;
inline constexpr std::size_t kMaxFaults = 32;

/// One process. "Host" or "participant" names the writer.
struct alignas(64) ParticipantSlot {
  FixedText<kNameLength> name;            // host, when the memory is created
  std::atomic<std::int32_t> pid{0};       // participant; 0: no process has attached
  std::atomic<std::uint32_t> ready{0};    // participant
  std::atomic<Part> part{Part::task};     // participant, before it is ready
  std::atomic<Membership> membership{};   // participant (left), host (dead)
  std::atomic<std::uint32_t> running{0};  // host sets, participant clears
  std::atomic<Tick> wake_tick{kNever};    // participant
  std::atomic<std::uint64_t> mail{0};     // participant: messages stored in its mailbox so far
  std::atomic<Tick> tick{0};              // host, before it opens the gate, as the two below
  std::atomic<std::uint64_t> delta{0};    // the delta in which the participant runs
  std::atomic<Wake> reason{Wake::tick};   // why it runs
  std::atomic<std::uint64_t> waits{0};    // participant; real: odd while it waits, 0 before the start
  std::atomic<bool> failed_with{false};   // the process that fails the clock: it took part then
  Gate gate;                              // the participant sleeps on it
};

/// The one sender of a topic.
struct alignas(64) SenderEntry {
  FixedText<kTopicLength> topic;
  std::uint32_t participant = 0;
  std::atomic<std::uint32_t> claimed{0};  // last of all
};

/// One receiver of a topic. Messages in flight on it: sent - arrived.
struct alignas(64) LinkEntry {
  FixedText<kTopicLength> topic;
  std::uint32_t receiver = 0;
  std::atomic<std::uint32_t> claimed{0};  // last of all
  std::atomic<std::int32_t> sender{-1};   // index into `senders`; host, at the start
  std::atomic<std::uint64_t> sent{0};     // its sender
  std::atomic<std::uint64_t> arrived{0};  // its receiver
};

struct ClockMemory {
  Mode mode = Mode::lockstep;
  std::int64_t period_ns = 0;
  std::int32_t host_pid = 0;
  std::uint32_t participant_count = 0;
  std::atomic<State> state{State::setting_up};
  std::atomic<Tick> stop_tick{kNever};  // newest tick when the owner requested the shutdown; kNever: not yet
  std::atomic<Tick> task_end{kNever};   // when the task ended, a participant died, or the owner requested the shutdown
  std::array<std::atomic<Tick>, kMaxFaults> fault_ticks;  // from which an injected fault is active; kNever
  std::atomic<std::uint32_t> failing{0};                  // claimed by the writer of `error`
  FixedText<1023> error;                                  // valid when state is `failed`
  std::atomic<std::int64_t> epoch_ns{0};                  // CLOCK_MONOTONIC at tick 0
  std::atomic<std::uint32_t> host_was_stopped{0};         // participant: a signal had stopped the host, hence the end
  std::atomic<Tick> tick{0};                              // lockstep: the newest tick that participants may see
  std::atomic<std::uint64_t> delta{0};                    // lockstep: the delta that is open
  EmergencyStop emergency_stop;                           // pressed by the operator, checked by every servo
  GroupStops group_stops;                                 // every servo
  Gate host;                                              // the host sleeps on it
  std::array<ParticipantSlot, kMaxParticipants + 1> participants;
  std::atomic<std::uint32_t> sender_count{0};
  std::array<SenderEntry, kMaxLinks> senders;
  std::atomic<std::uint32_t> link_count{0};
  std::array<LinkEntry, kMaxLinks> links;
};

/// The memory mapped into this process.
class MappedClock {
 public:
  /// Creates the memfd (closes on exec) and its mapping. `period` in s, a positive whole number of ns. Throws
  /// SystemError: names that are empty, too long, repeated or too many; a bad period; no memory.
  static MappedClock create(Mode mode, double period, const std::vector<std::string>& participants);
  /// Maps the memory behind `fd`, which stays the caller's. Throws SystemError when it is not a clock's.
  static MappedClock attach(int fd);
  ~MappedClock();
  MappedClock(MappedClock&& other) noexcept;
  MappedClock& operator=(MappedClock&&) = delete;

  ClockMemory& operator*() const noexcept { return *memory_; }
  ClockMemory* operator->() const noexcept { return memory_; }
  /// Descriptor of a memory that was created here; -1 otherwise. Closed with this object.
  int fd() const noexcept { return fd_; }

 private:
  MappedClock(ClockMemory* memory, int fd) noexcept : memory_(memory), fd_(fd) {}
  ClockMemory* memory_;
  int fd_;
};

/// Real and paced: CLOCK_MONOTONIC time at which `tick` begins, epoch + tick * period, ns; kForever when out of range.
std::int64_t begin_of(const ClockMemory& memory, Tick tick) noexcept;
/// Real: floor((now - epoch) / period); 0 before the epoch and before the start.
Tick wall_tick(const ClockMemory& memory) noexcept;

/// Lockstep: true when no live participant runs and no message is in flight on a live link. Only running participants
/// send and only the host sets one running, so the answer `true` stays true until the host (or the operator) acts. Any
/// thread; each thread that may have made it true calls it and opens the host's gate. It reads the running words first:
/// after that nothing more is sent.
bool quiescent(const ClockMemory& memory) noexcept;

/// Whether the host waits for messages on the link: its receiver takes part and its sender has not been lost.
bool live(const ClockMemory& memory, const LinkEntry& link) noexcept;

/// Enter a topic into the tables, before the start; return the index. Throw SystemError: the name is empty or too long,
/// the table is full, the clock has started.
int add_sender(ClockMemory& memory, std::uint32_t participant, std::string_view topic);
int add_link(ClockMemory& memory, std::uint32_t participant, std::string_view topic);
/// Host, at the start: assigns every link its sender. Throws SystemError when a topic has two.
void connect(ClockMemory& memory);
/// Counts one message in flight to each receiver of the sender's topic. No allocation.
void count_sent(ClockMemory& memory, int sender) noexcept;

/// Triggers injected fault `index` from `tick` on, unless it has been triggered. Any thread.
void set_off_fault(ClockMemory& memory, std::size_t index, Tick tick) noexcept;

/// The task has ended, in the newest tick, unless it has ended before. Any thread.
void end_task(ClockMemory& memory) noexcept;

/// Begins the shutdown: tasks are interrupted and not waited for any more, time continues for drives and world. Before
/// the start: as `end`. Any thread.
void stop(ClockMemory& memory) noexcept;

/// Ends the deployment's time, unless it has already ended (false): every wait of every process returns `interrupted`.
/// Any thread.
bool fail(ClockMemory& memory, std::string_view text) noexcept;
bool end(ClockMemory& memory) noexcept;

}  // namespace mrroc::clock
