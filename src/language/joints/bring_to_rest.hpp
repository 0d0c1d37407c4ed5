#pragma once

#include <vector>

#include "mrroc/robot.hpp"

namespace mrroc {

/// Commands the robots of `robots` that are in motion to hold until they rest, so that the caller can command all of
/// them at once. An instruction does this before an error leaves it. Each robot brakes within its limits. A robot that
/// reports an error during this stops on its own and is ignored. Errors of the exchange end it: the next instruction
/// throws them again. Task's thread.
void bring_to_rest(const std::vector<Robot*>& robots);

}  // namespace mrroc
