#pragma once

#include <vector>

#include "mrroc/robot_model.hpp"

namespace mrroc::bench {

/// The models of every robot in robots/, by name. CMake generates its source (bench/kinematics.cmake).
std::vector<RobotModels> load_robots();

}  // namespace mrroc::bench
