#pragma once

#include <string>

#include "mrroc/robot_model.hpp"

namespace mrroc::cli {

/// A line for each axis whose regulator the framework has designed: crossover, phase margin at the least, the design's
/// and the greatest inertia, and the range of inertia in which the loop is stable. Any thread.
std::string regulator_lines(const RobotModel& model);

}  // namespace mrroc::cli
