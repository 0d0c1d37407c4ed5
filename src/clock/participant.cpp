#include "clock/participant.hpp"

#include <unistd.h>

#include <string>
#include <utility>

#include "clock/clock_memory.hpp"
#include "clock/lockstep_clock.hpp"
#include "clock/wall/real_clock.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::clock {

namespace {

std::uint32_t claim_slot(ClockMemory& memory, std::string_view name) {
  std::string expected;
  for (std::uint32_t i = 0; i < memory.participant_count; ++i) {
    ParticipantSlot& slot = memory.participants[i];
    expected += (i == 0 ? "" : ", ") + std::string(slot.name.view());
    if (slot.name.view() != name) continue;
    std::int32_t none = 0;
    if (!slot.pid.compare_exchange_strong(none, ::getpid()))
      throw SystemError(ErrorCode::configuration, "clock: participant '" + std::string(name) +
                                                      "' is attached already, by process " + std::to_string(none));
    return i;
  }
  throw SystemError(ErrorCode::configuration,
                    "clock: participant '" + std::string(name) + "' is not expected: expected one of " + expected);
}

}  // namespace

std::unique_ptr<Clock> attach_clock(int fd, std::string_view name, Part part) {
  MappedClock memory = MappedClock::attach(fd);
  const std::uint32_t index = claim_slot(*memory, name);
  memory->participants[index].part.store(part);
  if (memory->mode == Mode::real) return std::make_unique<RealClock>(std::move(memory), index);
  return std::make_unique<LockstepClock>(std::move(memory), index);
}

}  // namespace mrroc::clock
