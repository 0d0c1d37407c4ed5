#pragma once

#include <string>

#include "cli/robot/urdf_arm.hpp"

namespace mrroc::cli {

/// What the framework makes of an arm, as lines for people: its axes with their limits, how its inverse is computed,
/// its reach, and how many of `postures` random postures within the limits the inverse finds again from their poses and
/// from another posture. The same arm gives the same text. Any thread.
std::string report_of(const UrdfArm& arm, int postures);

}  // namespace mrroc::cli
