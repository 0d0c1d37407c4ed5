#pragma once

namespace mrroc {

/// Limits of the tool along a path: maximum norms for position and for orientation; the jerk limits are 10 / s times
/// the accelerations. The path generators also keep the limits of the robot's joints: the tool is slower where a joint
/// would be too fast.
struct PathLimits {
  double speed = 0.1;                 ///< m/s
  double acceleration = 0.5;          ///< m/s^2
  double angular_speed = 0.3;         ///< rad/s
  double angular_acceleration = 1.0;  ///< rad/s^2
};

}  // namespace mrroc
