#pragma once

#include "mrroc/generator.hpp"
#include "mrroc/robot.hpp"

namespace mrroc {

/// Moves the tool at a constant velocity given in tool axes, until a condition of `.until(...)` holds: it has no end of
/// its own. The twist goes linearly from the desired one at the start (rest or not) to the given one, at `acceleration`
/// (m/s^2, and rad/s^2 for the angular part alike). The pose follows T(t + dt) = T(t) exp(xi dt), xi the mean of the
/// twists in tool axes at the two ends of the step.
class ToolVelocity : public Generator {
 public:
  /// `linear` (m/s) and `angular` (rad/s) in tool axes. Throws NonFatalError(not_finite, invalid_argument).
  ToolVelocity(Robot& robot, const Eigen::Vector3d& linear, const Eigen::Vector3d& angular = Eigen::Vector3d::Zero(),
               double acceleration = 0.2);

  void start() override;
  void next_state() override;

 private:
  Robot* robot_;
  Twist target_;  // in tool axes
  double acceleration_;
  Pose reference_ = Pose::Identity();  // desired at the end of the macrostep commanded last
  Twist twist_ = Twist::Zero();        // there, in tool axes
};

}  // namespace mrroc
