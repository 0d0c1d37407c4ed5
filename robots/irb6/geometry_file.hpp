#pragma once

#include "config/table.hpp"
#include "robots/irb6/geometry.hpp"

namespace mrroc::irb6 {

/// Reads `[geometry]` of irb6.toml, given as its table. Throws ConfigurationError, also for a screw whose length would
/// be zero at some angle and for gears of zero.
Geometry read_geometry(const config::Table& table);

}  // namespace mrroc::irb6
