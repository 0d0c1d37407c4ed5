#pragma once

#include "geometry/desired_state.hpp"
#include "geometry/joint_motion.hpp"
#include "language/macrostep/macrostep_path.hpp"
#include "mrroc/robot_command.hpp"
#include "mrroc/robot_state.hpp"
#include "mrroc/tool_kinematics.hpp"

namespace mrroc {

/// The goal of a command at the end of its macrostep, for every kind of path.
struct MacrostepGoal {
  DesiredState joints;              ///< for velocity commands: `velocity` alone
  MovingPose tool;                  ///< the same of the tool, where `wants_tool`
  bool wants_tool = false;          ///< the path is planned for the tool
  bool wants_velocity = false;      ///< a velocity alone, no position
  bool acceleration_given = false;  ///< else it is the mean acceleration of the macrostep
};

/// Reads `command`, validating every value of it; `from` is the desired state that increments start from, `duration`
/// that of the macrostep, s, `period` the servo's. A pose is turned into joints on the branch next to `from`, or,
/// where that one passes a limit and the path is not planned for the tool, into the nearest posture within the limits;
/// a twist into joint velocities (least squares, least norm where the robot is redundant). Class `none`, or a non-fatal
/// error. Allocates nothing, never throws. For commands of motion only.
ErrorReport read_goal(const RobotCommand& command, const DesiredState& from, const ToolKinematics& kinematics,
                      double duration, double period, MacrostepGoal& goal) noexcept;

/// Plans the path of a macrostep from `from` to `goal` and leaves the state at its end in `to`; a goal in motion
/// without an acceleration is reached with the macrostep's mean acceleration. Limits are not checked. Codes of
/// MacrostepPath; `invalid_argument` for an unknown interpolation. Allocates nothing, never throws.
ErrorCode plan_to(const MacrostepGoal& goal, Interpolation interpolation, const ToolKinematics& kinematics,
                  const DesiredState& from, double duration, double period, MacrostepPath& path,
                  DesiredState& to) noexcept;

}  // namespace mrroc
