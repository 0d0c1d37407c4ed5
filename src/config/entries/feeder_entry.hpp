#pragma once

#include <vector>

#include "config/deployment.hpp"
#include "config/table.hpp"

namespace mrroc::config {

/// The feeders of the table `sim`, in file order. Throws ConfigurationError: a name that is none, no parts, a part that
/// comes twice, times or spreads that are none. Whether the scene has the parts is seen when the world is built.
std::vector<FeederEntry> read_feeders(const Table& sim);

}  // namespace mrroc::config
