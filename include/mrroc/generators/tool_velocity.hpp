#pragma once

#include "mrroc/generator.hpp"
#include "mrroc/robot.hpp"

namespace mrroc {

/// Moves the tool at a constant velocity given in tool axes, until a condition of `.until(...)` holds; it does not end
/// on its own. The twist changes smoothly from the desired one at the start, with its rate there (rest or not), to the
/// given one,
///   xi(u) = xi0 + (xi1 - xi0) u^2 (3 - 2u) + xi0' D u (1 - u)^2,  u = t / D,
/// in tool axes, with D the least whole number of macrosteps in which its rate stays within `acceleration` (m/s^2, and
/// rad/s^2; or what it is at the start) and the rate's own rate within 10 / s times that. The pose follows T(t + dt) =
/// T(t) exp(integral of xi dt).
class ToolVelocity : public Generator {
 public:
  /// `linear` (m/s) and `angular` (rad/s) in tool axes. Throws NonFatalError(not_finite, invalid_argument).
  ToolVelocity(Robot& robot, const Eigen::Vector3d& linear, const Eigen::Vector3d& angular = Eigen::Vector3d::Zero(),
               double acceleration = 0.2);

  void start() override;
  void next_state() override;

 private:
  /// Whether the rates stay within the limits when the ramp takes `duration` s.
  bool gentle(double duration) const noexcept;
  /// Integral of xi from 0 to `t` s.
  Twist way(double t) const noexcept;

  Robot* robot_;
  Twist target_;  // in tool axes
  double acceleration_;
  double ramp_ = 0;                    // D, s
  double time_ = 0;                    // since the start, at the end of the macrostep commanded last
  Pose reference_ = Pose::Identity();  // desired there
  Twist start_ = Twist::Zero();        // xi0
  Twist rate_ = Twist::Zero();         // xi0'
};

}  // namespace mrroc
