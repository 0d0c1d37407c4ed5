#pragma once

#include "cli/trace/line.hpp"
#include "messages/mrroc_msgs/step.hpp"

namespace mrroc::cli::trace {

/// The step that a message of a recording describes. Throws Malformed when the message is not one of a step: a number
/// that is not finite, an invalid rotation, an unknown kind, a target of the wrong size.
Line to_line(const messages::mrroc_msgs::Step& step);

}  // namespace mrroc::cli::trace
