#pragma once

#include <cstdint>

#include "cli/trace/line.hpp"
#include "messages/mrroc_msgs/step.hpp"

namespace mrroc::cli::record {

/// The time of a tick, ns, as a recording has it: since tick 0.
constexpr std::uint64_t time_of(Tick tick, std::uint64_t period) noexcept { return tick * period; }
/// A time in ns.
messages::builtin_interfaces::Time stamp_at(std::uint64_t time) noexcept;
inline messages::builtin_interfaces::Time stamp_of(Tick tick, std::uint64_t period) noexcept {
  return stamp_at(time_of(tick, period));
}

/// A line of a trace as a message, to the last bit. `period`: of the servo, ns.
messages::mrroc_msgs::Step to_message(const trace::Line& line, std::uint64_t period);
/// The line again. Throws trace::Malformed, with field, value and what was expected, when the message is not one of a
/// step.
trace::Line to_line(const messages::mrroc_msgs::Step& step);

}  // namespace mrroc::cli::record
