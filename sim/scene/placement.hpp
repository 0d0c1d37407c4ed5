#pragma once

#include <vector>

#include "sim/scene/compose.hpp"
#include "sim/scene/mjcf_part.hpp"

namespace mrroc::sim {

/// Sets `pos` and `quat` of a body to `pose`.
void set_pose(Element& body, const Pose& pose);
/// A nameless body at the frame of `body` on its parent; the attributes that give the frame are moved there.
Element take_frame(Element& body);

/// The robots as bodies of the world: the content of the worldbody of `parts[i]` is in a body named as
/// `robots[i]`, at its base pose. A robot that is carried is in the body that has its carrier's site "<carrier>/tool",
/// at its base pose in the frame of that site (as given by the site's own attributes). The bodies are rigidly joined,
/// so MuJoCo lets neither of them, nor the next link of either, touch the other. Throws config::ConfigurationError when
/// a carrier has no such site.
std::vector<Element> place_robots(const std::vector<RobotPart>& robots, const std::vector<MjcfPart>& parts);

}  // namespace mrroc::sim
