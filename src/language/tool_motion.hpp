#pragma once

#include "geometry/moving_pose.hpp"
#include "mrroc/robot.hpp"

/// The motion of a robot's tool in its commands and states. Task's thread; never allocates or throws.
namespace mrroc {

/// At the end of the robot's commanded motion: pose, twist and twist's rate in base axes.
MovingPose desired_motion(const Robot& robot) noexcept;

/// Commands this motion of the tool at the macrostep's end.
void command_motion(RobotCommand& command, const MovingPose& motion) noexcept;

}  // namespace mrroc
