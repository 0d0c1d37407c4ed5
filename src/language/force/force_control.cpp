#include "mrroc/generators/force_control.hpp"

#include "mrroc/task.hpp"

namespace mrroc {

ForceControl::ForceControl(Robot& robot, const ForceLaw& law, const Eigen::Vector3d& linear,
                           const Eigen::Vector3d& angular)
    : Generator("ForceControl"), robot_(&robot), law_(law) {
  velocity_ << linear, angular;
  if (!velocity_.allFinite()) throw NonFatalError(ErrorCode::not_finite, "tool velocity of " + robot.name());
}

void ForceControl::next_state() {
  RobotCommand& command = robot_->command();
  command.kind = CommandKind::force;
  command.twist = robot_->task().operator_speed() * velocity_;
  command.force = law_;
}

}  // namespace mrroc
