#include "language/joints/motor_range.hpp"

#include "language/limits.hpp"
#include "mrroc/task.hpp"

namespace mrroc {

void check_motors(const Robot& robot, const JointVector& joints, const std::string& what) {
  const RobotModel& model = robot.kinematics().model();
  const ErrorOrigin origin{robot.task().process_name(), robot.name(), 0, robot.state().tick};
  JointVector motors;
  if (model.joints_to_motors(joints, motors) != ErrorCode::none)
    throw NonFatalError(ErrorCode::motor_limit, what + " the transmission cannot reach it", origin);
  for (std::size_t i = 0; i < model.parameters().axes.size(); ++i) {
    const AxisParameters& axis = model.parameters().axes[i];
    const double motor = motors[static_cast<Eigen::Index>(i)];
    if (is_within(motor, axis.motor_min, axis.motor_max)) continue;
    throw NonFatalError(
        ErrorCode::motor_limit,
        what + " motor " + axis.name + " at " + range_text(motor, axis.motor_min, axis.motor_max) + " rad", origin);
  }
}

}  // namespace mrroc
