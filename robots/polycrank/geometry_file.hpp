#pragma once

#include "config/table.hpp"
#include "robots/polycrank/geometry.hpp"

namespace mrroc::polycrank {

/// Reads `[geometry]` of polycrank.toml, given as its table. Throws ConfigurationError, also for a crank or a gear of
/// zero.
Geometry read_geometry(const config::Table& table);

}  // namespace mrroc::polycrank
