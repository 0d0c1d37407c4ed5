#pragma once

#include <vector>

#include "config/entries/shared_bus.hpp"

namespace mrroc::config {

/// Checks that the frames of all robots on a bus fit its bit rate, the key `bit_rate` of `can`, [robots.NAME.can]; 0:
/// unknown, not checked. `all`: the robots on the bus, this one last. Throws ConfigurationError.
void check_bus_capacity(const Table& can, double period, const std::vector<BusNodes>& all);

}  // namespace mrroc::config
