#pragma once

namespace mrroc {

/// Gain and limits of a visual servo.
struct ServoLimits {
  double gain = 1.0;           ///< lambda, 1/s
  double speed = 0.1;          ///< m/s, of the tool frame's origin
  double angular_speed = 0.3;  ///< rad/s
  double acceleration = 0.2;   ///< m/s^2 and rad/s^2 per tool axis; the jerk is 10 / s times that
  int patience = 50;           ///< consecutive steps without the target, after which the servo throws
};

}  // namespace mrroc
