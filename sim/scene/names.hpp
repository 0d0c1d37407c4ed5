#pragma once

#include <string>
#include <vector>

#include "sim/scene/xml.hpp"

namespace mrroc::sim {

/// Throws config::ConfigurationError when two elements of a kind have one name, which MuJoCo refuses without their
/// files. It names the file and line of the one that is not a robot's, else of the later one, and the position of the
/// other. `robots`: names, each the prefix of the names of what the robot has.
void check_names(const Element& root, const std::vector<std::string>& robots);

}  // namespace mrroc::sim
