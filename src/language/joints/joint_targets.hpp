#pragma once

#include "language/joints/nearest_posture.hpp"
#include "mrroc/robot.hpp"

/// Shared parts of generators that plan in joint space. Task's thread.
namespace mrroc {

/// Parts of a robot's limits that a motion in joint space is planned with. The EDP joins the points of the macrosteps'
/// ends by polynomials of degree five: their velocity and acceleration overshoot a little, and their jerk is the
/// least-squares fit of the motion's by a parabola, at most 2.18 times the motion's (the fit's Lebesgue constant).
inline constexpr double kVelocityShare = 0.99;
inline constexpr double kAccelerationShare = 0.9;
inline constexpr double kJerkShare = 0.45;

/// The least speed, as a fraction of the limits: at 0.5 rad/s a motion of 1 rad takes 23 days.
inline constexpr double kLeastSpeed = 1e-6;

/// Throws NonFatalError(invalid_argument) unless `speed`, a fraction of the limits, is in [kLeastSpeed, 1].
void check_speed(double speed);

/// Throws NonFatalError unless `joints` are as many as the robot's (invalid_argument), finite (not_finite) and within
/// its limits (joint_limit). `what` begins the text: "target".
void check_joints(const Robot& robot, const JointVector& joints, const std::string& what);

/// The pose with its rotation made exact (`make_rigid`). Throws NonFatalError: not_finite, invalid_argument when it is
/// not a rigid transform.
Pose rigid_pose(const Robot& robot, const Pose& pose, const std::string& what);

/// The posture of a tool pose that is nearest to `near`, on any branch and turn (`nearest_posture`). Throws
/// NonFatalError: out_of_workspace, joint_limit or motor_limit with the limit that the nearest one exceeds.
Posture posture_of(const Robot& robot, const Pose& pose, const JointVector& near, const std::string& what);

/// " position (x, y, z) m", and " (the name of the branch that `joints` are on)" or nothing: for the text of an error.
std::string place_text(const Pose& pose);
std::string branch_text(const Robot& robot, const JointVector& joints);

/// The joints of a tool pose on the branch nearest to `near`, ignoring the limits: for paths of the tool. Throws
/// NonFatalError: out_of_workspace, singular.
JointVector joints_on_branch(const Robot& robot, const Pose& pose, const JointVector& near, const std::string& what);

/// The joints at rest after each has braked on its own from the desired state, as fast as the shares of the limits
/// allow; not beyond the position limits.
JointVector resting_joints(const Robot& robot);

}  // namespace mrroc
