#pragma once

#include "mrroc/condition.hpp"
#include "mrroc/robot.hpp"

namespace mrroc {

/// The tool presses along a direction with at least `newtons`: the force that the environment exerts on it
/// (`RobotState::wrench`) has a component of -newtons or less along `direction`. Pressing along the tool's z axis is
/// TouchingAlong{arm, {0, 0, 1}, 10}. `Touching` is the same for any direction. The robot needs `force_sensor` in the
/// deployment; without it the condition never holds.
class TouchingAlong : public Condition {
 public:
  /// `direction` in tool axes, of any nonzero length. Throws NonFatalError(invalid_argument) unless it is finite and
  /// `newtons` is finite and above 0.
  TouchingAlong(const Robot& robot, const Eigen::Vector3d& direction, double newtons);

 protected:
  bool holds() override { return -robot_->state().wrench.head<3>().dot(direction_) >= newtons_; }

 private:
  const Robot* robot_;
  Eigen::Vector3d direction_;  ///< of length 1
  double newtons_;
};

}  // namespace mrroc
