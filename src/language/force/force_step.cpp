#include "language/force/force_step.hpp"

#include <algorithm>
#include <cmath>

#include "core/require.hpp"
#include "geometry/rigid_motion.hpp"
#include "mrroc/task.hpp"

namespace mrroc {

ToolPrediction predict_tool(const Robot& robot, bool first, double after) {
  const RobotState& state = robot.state();
  const Tick begin = first ? state.desired_tick : std::max(state.macrostep_start + robot.motion_steps(), state.tick);
  const double ahead =
      (static_cast<double>(begin) - static_cast<double>(state.desired_tick)) * robot.task().servo_period() + after;
  const Twist base = robot.kinematics().jacobian(state.desired_joints) * state.desired_velocity;
  ToolPrediction tool;
  tool.twist = rotate_twist(state.desired_pose.linear().transpose(), base);
  tool.pose = state.desired_pose * exp_twist(tool.twist * std::max(ahead, 0.0));
  return tool;
}

Wrench felt_without(const RobotState& state, const Load& load, const Eigen::Vector3d& gravity) {
  return state.wrench - weight_of(load, state.pose.linear(), gravity);
}

Eigen::Vector3d stepped(const Eigen::Vector3d& now, const Eigen::Vector3d& wanted, double most) {
  const Eigen::Vector3d change = wanted - now;
  const double size = change.norm();
  return size > most ? Eigen::Vector3d{now + change * (most / size)} : wanted;
}

double approach_speed(double remaining, double speed, double acceleration, double gain) {
  const double knee = acceleration / (gain * gain);
  if (remaining < knee) return std::min(speed, gain * std::max(remaining, 0.0));
  return std::min(speed, std::sqrt(2 * acceleration * (remaining - 0.5 * knee)));
}

void check_load(const char* caller, const Load& load, const Eigen::Vector3d& gravity) {
  require_not_negative(caller, "mass of the load", load.mass);
  require(load.centre.allFinite(), caller, "centre of the load", load.centre.sum(), "finite numbers");
  require(gravity.allFinite(), caller, "gravity", gravity.sum(), "finite numbers");
}

}  // namespace mrroc
