#include "language/macrostep/macrostep_goal.hpp"

#include <algorithm>
#include <cmath>

#include "core/error_report.hpp"
#include "geometry/rigid_motion.hpp"
#include "language/macrostep/macrostep_path.hpp"

namespace mrroc {
namespace {

constexpr double kTwistResidual = 1e-6;  // m/s, rad/s

ErrorReport refuse(ErrorCode code, const char* text) noexcept {
  return make_report(ErrorClass::non_fatal, code, "%s", text);
}

/// An empty vector means "not given".
ErrorReport check_vector(const JointVector& vector, const char* name, Eigen::Index count, bool may_be_empty) noexcept {
  if (vector.size() != count && !(may_be_empty && vector.size() == 0))
    return make_report(ErrorClass::non_fatal, ErrorCode::invalid_argument, "%s has %d values, expected %d", name,
                       static_cast<int>(vector.size()), static_cast<int>(count));
  for (Eigen::Index i = 0; i < vector.size(); ++i)
    if (!std::isfinite(vector[i]))
      return make_report(ErrorClass::non_fatal, ErrorCode::not_finite, "%s of axis %d is %g", name,
                         static_cast<int>(i) + 1, vector[i]);
  return {};
}

/// Joints, their velocity and acceleration as the command gives them; shafts alike.
ErrorReport read_axes(const RobotCommand& command, const JointVector& base, MacrostepGoal& goal) noexcept {
  const Eigen::Index count = base.size();
  const bool velocity_only = command.kind == CommandKind::joint_velocity;
  if (!velocity_only)
    if (const ErrorReport report = check_vector(command.joints, "joints", count, false); bad(report)) return report;
  if (const ErrorReport report = check_vector(command.joint_velocity, "joint_velocity", count, !velocity_only);
      bad(report))
    return report;
  if (const ErrorReport report = check_vector(command.joint_acceleration, "joint_acceleration", count, true);
      bad(report))
    return report;
  goal.joints = DesiredState::resting_at(base);
  if (!velocity_only) goal.joints.position = command.relative ? JointVector(base + command.joints) : command.joints;
  if (command.joint_velocity.size() != 0) goal.joints.velocity = command.joint_velocity;
  goal.acceleration_given = command.joint_acceleration.size() != 0;
  if (goal.acceleration_given) goal.joints.acceleration = command.joint_acceleration;
  return {};
}

/// Shafts to joints, with their velocities and accelerations.
ErrorReport shafts_to_joints(const RobotModel& model, double period, DesiredState& state) noexcept {
  JointVector joints;
  if (const ErrorCode code = model.motors_to_joints(state.position, joints); code != ErrorCode::none)
    return refuse(code, "no joints belong to the motors");
  if (!state.at_rest()) {
    const Eigen::PartialPivLU<JointMatrix> ratio(model.transmission(joints));
    state.velocity = ratio.solve(state.velocity);
    const double dt = MacrostepPath::kDifference * period;
    const JointVector step = state.velocity * dt;
    const JointMatrix change = model.transmission(joints + step) - model.transmission(joints - step);
    state.acceleration = ratio.solve(state.acceleration - change * state.velocity / (2 * dt));
    if (!state.velocity.allFinite() || !state.acceleration.allFinite())
      return refuse(ErrorCode::singular, "the transmission cannot be inverted there");
  }
  state.position = joints;
  return {};
}

ErrorReport read_twist(const RobotCommand& command, const Pose& tool, MacrostepGoal& goal) noexcept {
  if (!command.twist.allFinite()) return refuse(ErrorCode::not_finite, "a value of the twist");
  if (const ErrorReport report = check_vector(command.twist_acceleration, "twist_acceleration", 6, true); bad(report))
    return report;
  goal.tool.twist = command.twist;
  if (command.kind == CommandKind::twist && command.relative)  // in tool axes
    goal.tool.twist = rotate_twist(tool.linear(), command.twist);
  goal.acceleration_given = command.twist_acceleration.size() != 0;
  if (goal.acceleration_given) goal.tool.rate = command.twist_acceleration;
  return {};
}

/// Joint velocity and acceleration of the goal's twist, at the goal's joints.
ErrorReport twist_to_joints(const ToolKinematics& kinematics, double period, MacrostepGoal& goal) noexcept {
  if (goal.tool.twist.isZero(0) && goal.tool.rate.isZero(0)) return {};
  const double residual = joint_motion(kinematics, goal.joints.position, goal.tool, MacrostepPath::kDifference * period,
                                       goal.joints.velocity, goal.joints.acceleration);
  if (!(residual <= kTwistResidual * std::max(1.0, goal.tool.twist.norm())))
    return make_report(ErrorClass::non_fatal, ErrorCode::singular,
                       "the robot cannot move with the twist there: %.4g of it is out of reach", residual);
  return {};
}

ErrorReport read_pose(const RobotCommand& command, const DesiredState& from, const ToolKinematics& kinematics,
                      MacrostepGoal& goal) noexcept {
  if (!command.pose.matrix().allFinite()) return refuse(ErrorCode::not_finite, "a value of the pose");
  if (!is_rigid(command.pose)) return refuse(ErrorCode::invalid_argument, "the pose's orientation is not a rotation");
  goal.tool.pose = command.relative ? Pose(kinematics.direct(from.position) * command.pose) : command.pose;
  goal.joints = DesiredState::resting_at(from.position);
  // a path of the tool keeps its branch, a path of joints or motors may end on another one
  const ErrorCode code = command.interpolation == Interpolation::task
                             ? kinematics.follow(goal.tool.pose, from.position, goal.joints.position)
                             : kinematics.inverse(goal.tool.pose, from.position, goal.joints.position);
  const Eigen::Vector3d p = goal.tool.pose.translation();
  if (code != ErrorCode::none && code != ErrorCode::singular)
    return make_report(ErrorClass::non_fatal, code, "position (%.4g, %.4g, %.4g)", p.x(), p.y(), p.z());
  if (goal.joints.position.size() != from.position.size() || !goal.joints.position.allFinite())
    return refuse(ErrorCode::out_of_workspace, "the inverse kinematics has no solution");
  return {};
}

ErrorCode plan_tool(const MacrostepGoal& goal, const ToolKinematics& kinematics, const DesiredState& from,
                    double duration, double period, MacrostepPath& path, DesiredState& to) noexcept {
  MovingPose tool = goal.tool;
  if (!goal.acceleration_given && !tool.twist.isZero(0))
    tool.rate = (tool.twist - tool_motion(kinematics, from, MacrostepPath::kDifference * period).twist) / duration;
  const ErrorCode code = path.plan_task(kinematics, from, tool, duration, period);
  if (code != ErrorCode::none || to.at_rest()) return code;
  const JointVector joints = to.position;
  return path.at(duration, joints, to);
}

}  // namespace

ErrorReport read_goal(const RobotCommand& command, const DesiredState& from, const ToolKinematics& kinematics,
                      double duration, double period, MacrostepGoal& goal) noexcept {
  const RobotModel& model = kinematics.model();
  goal = MacrostepGoal{};
  goal.wants_tool = command.interpolation == Interpolation::task;
  switch (command.kind) {
    case CommandKind::joint:
      if (const ErrorReport report = read_axes(command, from.position, goal); bad(report)) return report;
      break;
    case CommandKind::motor: {
      JointVector shafts;
      if (const ErrorCode code = model.joints_to_motors(from.position, shafts); code != ErrorCode::none)
        return refuse(code, "the robot is at a position that its transmission cannot reach");
      if (const ErrorReport report = read_axes(command, shafts, goal); bad(report)) return report;
      if (const ErrorReport report = shafts_to_joints(model, period, goal.joints); bad(report)) return report;
      break;
    }
    case CommandKind::pose:
      if (const ErrorReport report = read_pose(command, from, kinematics, goal); bad(report)) return report;
      if (const ErrorReport report = read_twist(command, goal.tool.pose, goal); bad(report)) return report;
      return twist_to_joints(kinematics, period, goal);
    case CommandKind::joint_velocity:
      goal.wants_velocity = true;
      return read_axes(command, from.position, goal);
    case CommandKind::twist:
      goal.wants_velocity = true;
      goal.joints = DesiredState::resting_at(from.position + from.velocity * (0.5 * duration));
      if (const ErrorReport report = read_twist(command, kinematics.direct(from.position), goal); bad(report))
        return report;
      return twist_to_joints(kinematics, period, goal);
    default:
      return make_report(ErrorClass::non_fatal, ErrorCode::invalid_argument, "kind %d is not a motion",
                         static_cast<int>(command.kind));
  }
  if (goal.wants_tool) goal.tool = tool_motion(kinematics, goal.joints, MacrostepPath::kDifference * period);
  return {};
}

ErrorCode plan_to(const MacrostepGoal& goal, Interpolation interpolation, const ToolKinematics& kinematics,
                  const DesiredState& from, double duration, double period, MacrostepPath& path,
                  DesiredState& to) noexcept {
  to = goal.joints;
  if (goal.wants_velocity) {
    path.plan_velocity(kinematics.model().parameters(), from, goal.joints.velocity);
    return path.at(duration, from.position, to);
  }
  if (!goal.acceleration_given && !(to.velocity.array() == 0.0).all())
    to.acceleration = (to.velocity - from.velocity) / duration;
  switch (interpolation) {
    case Interpolation::joints:
      path.plan_joints(from, to, duration);
      return ErrorCode::none;
    case Interpolation::motors:
      return path.plan_motors(kinematics.model(), from, to, duration, period);
    case Interpolation::task:
      return plan_tool(goal, kinematics, from, duration, period, path, to);
    default:
      return ErrorCode::invalid_argument;
  }
}

}  // namespace mrroc
