#pragma once

#include <vector>

#include "mrroc/robot.hpp"

namespace mrroc {

/// Commands the robots of `robots` that are in motion to hold until they rest, so that the caller can command all of
/// them at once: what an instruction does before an error leaves it. Each robot brakes within its limits. A robot that
/// reports an error meanwhile stops on its own and is left alone. Errors of the exchange end it: the next instruction
/// meets them again. Task's thread.
void bring_to_rest(const std::vector<Robot*>& robots);

}  // namespace mrroc
