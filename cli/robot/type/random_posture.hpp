#pragma once

#include <cmath>
#include <numbers>
#include <random>

#include "mrroc/robot_parameters.hpp"

namespace mrroc::cli {

/// Uniform within the limits; within a turn, or 3.1 m, where an axis has none.
inline JointVector random_posture(const RobotParameters& parameters, std::mt19937_64& random) {
  JointVector joints(std::ssize(parameters.axes));
  for (std::size_t i = 0; i < parameters.axes.size(); ++i) {
    const AxisParameters& axis = parameters.axes[i];
    const double min = std::isfinite(axis.position_min) ? axis.position_min : -std::numbers::pi;
    const double max = std::isfinite(axis.position_max) ? axis.position_max : std::numbers::pi;
    joints[static_cast<Eigen::Index>(i)] = std::uniform_real_distribution(min, max)(random);
  }
  return joints;
}

}  // namespace mrroc::cli
