#pragma once

#include "config/table.hpp"
#include "robots/serial_parallel/geometry.hpp"

namespace mrroc::serial_parallel {

/// Reads `[geometry]` of serial_parallel.toml, given as its table. Throws ConfigurationError, also for gears of zero,
/// for legs A and C hinged at one point and for limits of leg B that are out of order.
Geometry read_geometry(const config::Table& table);

}  // namespace mrroc::serial_parallel
