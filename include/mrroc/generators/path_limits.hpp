#pragma once

namespace mrroc {

/// How fast the tool goes along a path: the most of position and orientation each, as lengths of vectors; the jerks are
/// 10 / s times the accelerations. The generators of paths keep the limits of the robot's joints, too: the path is
/// slower where a joint would be too fast.
struct PathLimits {
  double speed = 0.1;                 ///< m/s
  double acceleration = 0.5;          ///< m/s^2
  double angular_speed = 0.3;         ///< rad/s
  double angular_acceleration = 1.0;  ///< rad/s^2
};

}  // namespace mrroc
