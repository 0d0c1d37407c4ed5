#pragma once

#include "geometry/desired_state.hpp"
#include "geometry/moving_pose.hpp"
#include "mrroc/tool_kinematics.hpp"

namespace mrroc {

/// The tool's motion that belongs to a motion of the joints (geometry/moving_pose.hpp).
MovingPose tool_motion(const ToolKinematics& kinematics, const DesiredState& joints, double dt) noexcept;

/// The joint velocity that gives the tool this twist at `joints`: dq/dt = J^+ twist, least squares, of least norm where
/// the robot is redundant, the model's `kept_joint` at rest.
JointVector joint_velocity_of(const ToolKinematics& kinematics, const JointVector& joints, const Twist& twist) noexcept;

/// The joints' velocity and acceleration that give the tool this motion at `joints`: that of `joint_velocity_of` and
/// its derivative in time, the central difference over +-`dt` s. Returns the part of the twist that is out of reach, as
/// the norm of the residual.
double joint_motion(const ToolKinematics& kinematics, const JointVector& joints, const MovingPose& tool, double dt,
                    JointVector& velocity, JointVector& acceleration) noexcept;

}  // namespace mrroc
