#pragma once

#include <string>

#include "kinematics/chain_model.hpp"

namespace mrroc::cli {

/// What the framework makes of an arm from link `base` to link `tip`, as lines for people: its axes with their limits,
/// how its inverse is computed, its workspace, its singularities, and how many of `postures` random postures within the
/// limits the inverse finds again from their poses and from another posture. The same arm gives the same text. Any
/// thread.
std::string report_of(const kinematics::ChainModel& model, const std::string& base, const std::string& tip,
                      int postures);

}  // namespace mrroc::cli
