#include "language/tool_motion.hpp"

namespace mrroc {

MovingPose desired_motion(const Robot& robot) noexcept {
  constexpr double kPoseDifference = 1e-3;  // s
  const RobotState& state = robot.state();
  MovingPose tool = tool_motion(robot.kinematics(), state.desired_joints, state.desired_velocity,
                                state.desired_acceleration, kPoseDifference);
  tool.pose = state.desired_pose;
  return tool;
}

void command_motion(RobotCommand& command, const MovingPose& motion) noexcept {
  command.kind = CommandKind::pose;
  command.pose = motion.pose;
  command.twist = motion.twist;
  command.twist_acceleration = motion.rate;
}

}  // namespace mrroc
