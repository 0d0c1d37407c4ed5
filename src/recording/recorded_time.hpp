#pragma once

#include <cstdint>

#include "messages/builtin_interfaces/time.hpp"
#include "mrroc/types.hpp"

namespace mrroc::recording {

/// A time in ns, to the nearest.
std::uint64_t nanoseconds_of(double seconds) noexcept;

/// The time of a tick, ns, as a recording has it: since tick 0.
constexpr std::uint64_t time_of(Tick tick, std::uint64_t period) noexcept { return tick * period; }

/// The same as two numbers, of a time in ns.
messages::builtin_interfaces::Time stamp_at(std::uint64_t time) noexcept;
inline messages::builtin_interfaces::Time stamp_of(Tick tick, std::uint64_t period) noexcept {
  return stamp_at(time_of(tick, period));
}

}  // namespace mrroc::recording
