#pragma once

#include <vector>

#include "mrroc/common_stop.hpp"
#include "mrroc/robot.hpp"

namespace mrroc {

/// The stop with which `robots` would come to rest together from their desired states, each joint with about 0.8 of its
/// acceleration and jerk limits; `ticks` is 0 when all of them rest. Where they brake already, its rate is that of the
/// speed along their common way: the sum of a v over all joints divided by that of v^2, each in units of its velocity
/// limit; else 0.
///
/// An estimate for commands that continue from these states: an EDP whose robot would leave its limits stops on its
/// own. Allocates nothing, never throws; the task's thread.
CommonStop common_stop(const std::vector<Robot*>& robots, double period) noexcept;

}  // namespace mrroc
