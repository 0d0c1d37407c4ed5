#pragma once

#include "mrroc/load.hpp"
#include "mrroc/robot.hpp"

/// Shared parts of the generators of force motions. Task's thread; allocates nothing.
namespace mrroc {

/// The desired pose and motion of the tool.
struct ToolPrediction {
  Pose pose = Pose::Identity();
  Twist twist = Twist::Zero();  ///< in tool axes
};

/// The tool `after` s past the start of the coming macrostep at its present motion. `first`: the current macrostep, if
/// any, is not a force motion, so its end is known; else the state's desired values are those of its reply.
ToolPrediction predict_tool(const Robot& robot, bool first, double after);

/// The measured wrench without the load's weight, tool axes.
Wrench felt_without(const RobotState& state, const Load& load, const Eigen::Vector3d& gravity);

/// `now`, changed towards `wanted` by at most `most` in norm.
Eigen::Vector3d stepped(const Eigen::Vector3d& now, const Eigen::Vector3d& wanted, double most);

/// The maximum speed with `remaining` (m, rad) to go of a motion that can stop at `acceleration`, or converges at
/// `gain` (1/s) when it is near.
double approach_speed(double remaining, double speed, double acceleration, double gain);

/// Throws NonFatalError(invalid_argument) unless the mass is finite and not negative, centre and gravity finite.
void check_load(const char* caller, const Load& load, const Eigen::Vector3d& gravity);

}  // namespace mrroc
