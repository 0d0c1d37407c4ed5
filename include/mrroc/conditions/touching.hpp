#pragma once

#include "mrroc/condition.hpp"
#include "mrroc/robot.hpp"

namespace mrroc {

/// The norm of the force that the robot's own force sensor measures (`RobotState::wrench`) is at least `newtons`. The
/// robot needs `force_sensor` in the deployment; without it the condition never holds.
class Touching : public Condition {
 public:
  /// Throws NonFatalError(invalid_argument) unless `newtons` is finite and above 0.
  Touching(const Robot& robot, double newtons);

 protected:
  bool holds() override { return robot_->state().wrench.head<3>().norm() >= newtons_; }

 private:
  const Robot* robot_;
  double newtons_;
};

}  // namespace mrroc
