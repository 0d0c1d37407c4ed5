#pragma once

#include <string>
#include <vector>

#include "cli/record/signals.hpp"

namespace mrroc::cli::record {

/// Draws signals over the time of the run as an SVG picture: a panel for each group, with a line for each of its
/// signals. Where lines have more points than the picture has columns, the least and the greatest value of each column
/// are drawn, so that no peak is lost. No group is empty. Pure function; any thread.
std::string draw(const std::vector<std::vector<Signal>>& groups);

}  // namespace mrroc::cli::record
