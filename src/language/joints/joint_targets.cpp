#include "language/joints/joint_targets.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <ruckig/ruckig.hpp>

#include "geometry/rigid_motion.hpp"
#include "language/limits.hpp"
#include "mrroc/task.hpp"

namespace mrroc {

namespace {

/// The shortest text that reads back to the same bits: 9e-07.
std::string shortest(double value) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

}  // namespace

void check_speed(double speed) {
  if (speed >= kLeastSpeed && speed <= 1) return;
  throw NonFatalError(ErrorCode::invalid_argument,
                      "speed " + shortest(speed) + ", expected " + shortest(kLeastSpeed) + " to 1");
}

void check_joints(const Robot& robot, const JointVector& joints, const std::string& what) {
  const auto& axes = robot.parameters().axes;
  const ErrorOrigin origin{robot.task().process_name(), robot.name(), 0, 0};
  if (static_cast<std::size_t>(joints.size()) != axes.size()) {
    throw NonFatalError(
        ErrorCode::invalid_argument,
        what + " has " + std::to_string(joints.size()) + " joints, expected " + std::to_string(axes.size()), origin);
  }
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const double position = joints[static_cast<Eigen::Index>(i)];
    if (!std::isfinite(position))
      throw NonFatalError(ErrorCode::not_finite, what + " of joint " + axes[i].name, origin);
    if (!is_within(position, axes[i].position_min, axes[i].position_max)) {
      throw NonFatalError(ErrorCode::joint_limit,
                          what + " of joint " + axes[i].name + " is " +
                              range_text(position, axes[i].position_min, axes[i].position_max),
                          origin);
    }
  }
}

namespace {

ErrorOrigin origin_of(const Robot& robot) { return {robot.task().process_name(), robot.name(), 0, robot.state().tick}; }

/// The reason why no posture is within the limits.
std::string refusal_text(const Robot& robot, const Posture& posture) {
  if (posture.code == ErrorCode::out_of_workspace) {
    if (posture.deviation.position == 0 && posture.deviation.rotation == 0) return "";
    return ": the nearest pose of the robot is " + std::to_string(1e3 * posture.deviation.position) + " mm and " +
           std::to_string(1e3 * posture.deviation.rotation) + " mrad off, expected at most " +
           std::to_string(1e3 * kPositionTolerance) + " mm and " + std::to_string(1e3 * kRotationTolerance) + " mrad";
  }
  const std::string text = ": no branch is within the limits, the nearest has ";
  if (posture.axis < 0) return text + "joints that the transmission cannot reach";
  const AxisParameters& axis = robot.parameters().axes[static_cast<std::size_t>(posture.axis)];
  if (posture.code == ErrorCode::motor_limit)
    return text + "motor " + axis.name + " at " + range_text(posture.value, axis.motor_min, axis.motor_max);
  return text + "joint " + axis.name + " at " + range_text(posture.value, axis.position_min, axis.position_max);
}

}  // namespace

std::string place_text(const Pose& pose) {
  const Eigen::Vector3d p = pose.translation();
  return " position (" + std::to_string(p.x()) + ", " + std::to_string(p.y()) + ", " + std::to_string(p.z()) + ") m";
}

std::string branch_text(const Robot& robot, const JointVector& joints) {
  const std::string_view name = robot.kinematics().model().branch_name(joints);
  return name.empty() ? "" : " (" + std::string(name) + ")";
}

Pose rigid_pose(const Robot& robot, const Pose& pose, const std::string& what) {
  Pose exact = pose;
  if (make_rigid(exact)) return exact;
  const bool finite = pose.matrix().allFinite();
  throw NonFatalError(finite ? ErrorCode::invalid_argument : ErrorCode::not_finite,
                      what + " pose is not a rigid transform" +
                          (finite ? ": its rotation is scaled, sheared or reflected" : ": a value is not finite"),
                      origin_of(robot));
}

Posture posture_of(const Robot& robot, const Pose& pose, const JointVector& near, const std::string& what) {
  Posture posture = nearest_posture(robot.kinematics(), rigid_pose(robot, pose, what), near);
  if (posture.code == ErrorCode::none) return posture;
  throw NonFatalError(posture.code, what + place_text(pose) + refusal_text(robot, posture), origin_of(robot));
}

JointVector joints_on_branch(const Robot& robot, const Pose& pose, const JointVector& near, const std::string& what) {
  JointVector joints = near;
  const ErrorCode code = robot.kinematics().follow(pose, near, joints);
  if (code != ErrorCode::none)
    throw NonFatalError(code, what + place_text(pose) + " on the branch" + branch_text(robot, near) + " of the motion",
                        origin_of(robot));
  return joints;
}

JointVector resting_joints(const Robot& robot) {
  const RobotState& state = robot.known_state();
  JointVector rest = state.desired_joints;
  ruckig::Ruckig<1> ruckig;
  ruckig::InputParameter<1> input;
  ruckig::Trajectory<1> trajectory;
  input.control_interface = ruckig::ControlInterface::Velocity;
  input.target_velocity[0] = input.target_acceleration[0] = 0;
  for (std::size_t i = 0; i < robot.parameters().axes.size(); ++i) {
    const AxisParameters& axis = robot.parameters().axes[i];
    const auto row = static_cast<Eigen::Index>(i);
    input.current_position[0] = state.desired_joints[row];
    input.current_velocity[0] = state.desired_velocity[row];
    input.current_acceleration[0] = state.desired_acceleration[row];
    input.max_acceleration[0] = kAccelerationShare * axis.acceleration_max;
    input.max_jerk[0] = kJerkShare * axis.jerk_max;
    if (ruckig.calculate(input, trajectory) < 0) continue;  // stays where it is: planning from there reports the reason
    std::array<double, 1> position{}, velocity{}, acceleration{};
    trajectory.at_time(trajectory.get_duration(), position, velocity, acceleration);
    rest[row] = std::clamp(position[0], std::min(axis.position_min, state.desired_joints[row]),
                           std::max(axis.position_max, state.desired_joints[row]));
  }
  return rest;
}

}  // namespace mrroc
