#pragma once

#include "mrroc/force_law.hpp"
#include "mrroc/generator.hpp"
#include "mrroc/robot.hpp"

namespace mrroc {

/// Moves the tool under a force law that the robot's EDP follows at every servo tick, until a condition of
/// `.until(...)` holds; it does not end on its own. Unguarded axes move with the given velocity, guarded axes too while
/// nothing is in contact, contact axes press. The robot needs `force_sensor` in the deployment; call
/// `robot.bias_force()` first to remove the tool's weight.
class ForceControl : public Generator {
 public:
  /// `linear` (m/s) and `angular` (rad/s) in tool axes. Throws NonFatalError(not_finite).
  ForceControl(Robot& robot, const ForceLaw& law, const Eigen::Vector3d& linear = Eigen::Vector3d::Zero(),
               const Eigen::Vector3d& angular = Eigen::Vector3d::Zero());

  void next_state() override;

 private:
  Robot* robot_;
  ForceLaw law_;
  Twist velocity_;
};

}  // namespace mrroc
