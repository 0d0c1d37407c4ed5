#pragma once

#include "mrroc/generator.hpp"
#include "mrroc/robot.hpp"

namespace mrroc {

/// Moves the tool at a constant velocity given in tool axes, until a condition of `.until(...)` holds: it has no end of
/// its own. The speed rises linearly from the state at the start, at `acceleration` (m/s^2, and rad/s^2 for the angular
/// part alike). The pose follows T(t + dt) = T(t) exp(xi dt), xi the mean twist of the step in tool axes.
class ToolVelocity : public Generator {
 public:
  /// `linear` (m/s) and `angular` (rad/s) in tool axes. Throws NonFatalError(not_finite, invalid_argument).
  ToolVelocity(Robot& robot, const Eigen::Vector3d& linear, const Eigen::Vector3d& angular = Eigen::Vector3d::Zero(),
               double acceleration = 0.2);

  void start() override;
  void next_state() override;

 private:
  Robot* robot_;
  Twist twist_;           // in tool axes
  double ramp_duration_;  // s from rest to the whole velocity
  Pose reference_ = Pose::Identity();
  double fraction_ = 0;  // of the velocity, reached so far
};

}  // namespace mrroc
