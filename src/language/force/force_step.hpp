#pragma once

#include "mrroc/load.hpp"
#include "mrroc/robot.hpp"

/// What the generators of force motions share. Task's thread; allocates nothing.
namespace mrroc {

/// Where the tool should be, and how it should move there.
struct ToolPrediction {
  Pose pose = Pose::Identity();
  Twist twist = Twist::Zero();  ///< in tool axes
};

/// The tool `after` s past the start of the coming macrostep, continuing as it does now. `first`: the macrostep under
/// way, if there is one, is not a force motion, so its end is known; else the state's desired values are those of its
/// reply.
ToolPrediction predict_tool(const Robot& robot, bool first, double after);

/// The measured wrench without the load's weight, tool axes.
Wrench felt_without(const RobotState& state, const Load& load, const Eigen::Vector3d& gravity);

/// `now`, changed towards `wanted` by at most `most` in norm.
Eigen::Vector3d stepped(const Eigen::Vector3d& now, const Eigen::Vector3d& wanted, double most);

/// The speed at which a motion that can stop at `acceleration`, or closes in at `gain` (1/s) when it is near, may have
/// with `remaining` (m, rad) to go.
double approach_speed(double remaining, double speed, double acceleration, double gain);

/// Throws NonFatalError(invalid_argument) unless the mass is finite and not negative, centre and gravity finite.
void check_load(const char* who, const Load& load, const Eigen::Vector3d& gravity);

}  // namespace mrroc
