#pragma once

#include <string>
#include <vector>

#include "config/entries/errors_entry.hpp"
#include "sim/scene/xml.hpp"

namespace mrroc::sim {

/// Moves every body of robot `robot` that has a hinge or a slide by its error (`error_of_link`), in the frame that the
/// MJCF gives it. `world`: the children of its worldbody, with the robot's prefix.
void misplace_links(std::vector<Element>& world, const config::ErrorsEntry& errors, const std::string& robot);

}  // namespace mrroc::sim
