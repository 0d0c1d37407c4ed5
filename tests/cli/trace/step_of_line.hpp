#pragma once

#include "cli/trace/line.hpp"
#include "messages/mrroc_msgs/step.hpp"

namespace mrroc::cli::trace {

/// The message that a process writes for a step which is read as this line. `period`: of the servo, ns.
messages::mrroc_msgs::Step to_message(const Line& line, std::uint64_t period);

}  // namespace mrroc::cli::trace
