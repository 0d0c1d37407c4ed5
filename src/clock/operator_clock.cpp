#include "clock/operator_clock.hpp"

#include "clock/wall/monotonic.hpp"

namespace mrroc::clock {

Wake OperatorClock::wait(Tick wake_tick) {
  constexpr std::int64_t kLook = kSecond / 100;
  for (;;) {
    const std::uint32_t word = slot().gate.word();
    if (slot().gate.interrupted()) return Wake::interrupted;
    const bool mail = Gate::openings(word) != seen_;
    seen_ = Gate::openings(word);
    if (tick() >= wake_tick) return Wake::tick;
    if (mail) return Wake::mail;
    if (!sleep(word, monotonic_ns() + kLook)) return Wake::interrupted;
  }
}

}  // namespace mrroc::clock
