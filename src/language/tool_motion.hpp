#pragma once

#include "geometry/moving_pose.hpp"
#include "mrroc/robot.hpp"

/// The motion of a robot's tool as its commands and states have it. The task's thread; never allocates or throws.
namespace mrroc {

/// At the end of what the robot has been commanded: pose, twist and twist's rate in base axes.
MovingPose desired_motion(const Robot& robot) noexcept;

/// Commands the tool to move so at the macrostep's end.
void command_motion(RobotCommand& command, const MovingPose& motion) noexcept;

}  // namespace mrroc
