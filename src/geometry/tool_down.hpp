#pragma once

#include "mrroc/types.hpp"

namespace mrroc {

/// The pose at (x, y, z) m whose z axis points straight down and whose x axis is the frame's: R = diag(1, -1, -1). Any
/// thread; never throws.
inline Pose tool_down(double x, double y, double z) noexcept {
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::Vector3d(1, -1, -1).asDiagonal();
  pose.translation() = Eigen::Vector3d(x, y, z);
  return pose;
}

}  // namespace mrroc
