#pragma once

#include "config/deployment.hpp"
#include "config/table.hpp"

namespace mrroc::config {

/// Checks `mount` of every robot of `deployment`, which was read from `root`: it names a robot, no robot carries itself
/// through others, and a simulated robot is carried by a simulated one. Throws ConfigurationError.
void check_mounts(const Table& root, const Deployment& deployment);

}  // namespace mrroc::config
