#pragma once

#include <vector>

#include "config/deployment.hpp"
#include "config/table.hpp"

namespace mrroc::config {

/// The feeders of the table `sim`, in file order. Throws ConfigurationError: an invalid name, no parts, a part that is
/// listed twice, invalid times or spreads. The parts are checked against the scene when the world is built.
std::vector<FeederEntry> read_feeders(const Table& sim);

}  // namespace mrroc::config
