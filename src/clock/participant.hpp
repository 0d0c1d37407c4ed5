#pragma once

#include <memory>
#include <string_view>

#include "clock/clock.hpp"

namespace mrroc::clock {

/// Joins the deployment as `name` through the clock memory behind `fd` (inherited from the host) and returns the clock
/// of the deployment's mode. Destroying the clock leaves the deployment. Throws SystemError: `fd` is not a clock
/// memory, the host does not expect that name, another process has joined under it, the host has died.
std::unique_ptr<Clock> attach_clock(int fd, std::string_view name, Part part = Part::task);

}  // namespace mrroc::clock
