#include "edp/planner.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "edp/error_report.hpp"

namespace mrroc::edp {
namespace {

constexpr double kOrthogonality = 1e-6;  // of the rotation of a commanded pose
constexpr double kTwistResidual = 1e-6;  // m/s, rad/s
constexpr std::uint32_t kMaxStretchedSteps = 4 * kMaxMotionSteps;

bool bad(const ErrorReport& report) noexcept { return report.error_class != ErrorClass::none; }

/// An empty vector stands for zero.
ErrorReport check_vector(const JointVector& vector, const char* name, Eigen::Index count, bool may_be_empty) noexcept {
  if (vector.size() != count && !(may_be_empty && vector.size() == 0))
    return make_report(ErrorClass::non_fatal, ErrorCode::invalid_argument, "%s has %d values, the robot %d axes", name,
                       static_cast<int>(vector.size()), static_cast<int>(count));
  for (Eigen::Index i = 0; i < vector.size(); ++i)
    if (!std::isfinite(vector[i]))
      return make_report(ErrorClass::non_fatal, ErrorCode::not_finite, "%s of axis %d is %g", name,
                         static_cast<int>(i) + 1, vector[i]);
  return {};
}

}  // namespace

Planner::Planner(const RobotModel& model, double period)
    : kinematics_(model), period_(period), stop_(model.parameters(), period), limits_(model, period) {}

ErrorReport Planner::plan(const RobotCommand& command, const DesiredState& from, Pace pace,
                          Macrostep& macrostep) noexcept {
  const int steps = command.motion_steps;
  if (steps < 1 || steps > kMaxMotionSteps)
    return make_report(ErrorClass::non_fatal, ErrorCode::invalid_motion_steps, "N = %d, expected 1..%d", steps,
                       int{kMaxMotionSteps});
  if (command.reply_step < 1 || command.reply_step > steps + 1)
    return make_report(ErrorClass::non_fatal, ErrorCode::invalid_reply_step, "v = %d, expected 1..N+1 = %d",
                       int{command.reply_step}, steps + 1);

  ErrorReport report;
  DesiredState to = DesiredState::resting_at(from.position);
  switch (command.kind) {
    case CommandKind::hold:
      plan_stop(from, command.motion_steps, macrostep);
      break;
    case CommandKind::joint:
      report = joint_target(command, from, to);
      break;
    case CommandKind::pose:
      report = pose_target(command, from, to);
      break;
    default:
      return make_report(ErrorClass::non_fatal, ErrorCode::invalid_argument, "kind %d is not a motion",
                         static_cast<int>(command.kind));
  }
  if (bad(report)) return report;
  if (command.kind != CommandKind::hold) {
    macrostep.kind = Macrostep::Kind::path;
    macrostep.steps = command.motion_steps;
    macrostep.from = from;
    macrostep.to = to;
    report = plan_path(macrostep);
    if (bad(report) && pace == Pace::stretched) report = stretch(report, macrostep);
  }
  // v = N+1 means "after the macrostep", however long it has become
  macrostep.reply_step = command.reply_step > command.motion_steps ? macrostep.steps + 1 : command.reply_step;
  return report;
}

void Planner::plan_stop(const DesiredState& from, std::uint32_t steps, Macrostep& macrostep) noexcept {
  stop_.plan(from);
  macrostep.kind = Macrostep::Kind::stop;
  macrostep.steps = std::max(steps, stop_.ticks());
  macrostep.from = from;
  macrostep.to = stop_.end();
}

ErrorReport Planner::plan_path(Macrostep& macrostep) noexcept {
  macrostep.path.plan(macrostep.from, macrostep.to, macrostep.steps * period_);
  return limits_.check(macrostep);
}

ErrorReport Planner::stretch(ErrorReport report, Macrostep& macrostep) noexcept {
  const std::uint32_t commanded = macrostep.steps;
  for (const bool at_rest : {false, true}) {
    if (at_rest) macrostep.to = DesiredState::resting_at(macrostep.to.position);
    macrostep.steps = commanded;
    if (bad(limits_.check_end(macrostep))) continue;
    while (bad(report = plan_path(macrostep))) {
      // a longer run-up swings farther out, a longer way to rest does not
      if (!at_rest && (report.code == ErrorCode::joint_limit || report.code == ErrorCode::motor_limit)) break;
      if (macrostep.steps >= kMaxStretchedSteps) break;
      macrostep.steps = std::min(macrostep.steps + macrostep.steps / 4 + 1, kMaxStretchedSteps);
    }
    if (!bad(report)) break;
  }
  return report;
}

ErrorReport Planner::joint_target(const RobotCommand& command, const DesiredState& from,
                                  DesiredState& to) const noexcept {
  const Eigen::Index count = kinematics_.model().joint_count();
  if (const ErrorReport report = check_vector(command.joints, "joints", count, false); bad(report)) return report;
  if (const ErrorReport report = check_vector(command.joint_velocity, "joint_velocity", count, true); bad(report))
    return report;
  if (const ErrorReport report = check_vector(command.joint_acceleration, "joint_acceleration", count, true);
      bad(report))
    return report;
  to.position = command.joints;
  if (command.relative) to.position += from.position;
  if (command.joint_velocity.size() != 0) to.velocity = command.joint_velocity;
  if (command.joint_acceleration.size() != 0) to.acceleration = command.joint_acceleration;
  return {};
}

ErrorReport Planner::pose_target(const RobotCommand& command, const DesiredState& from,
                                 DesiredState& to) const noexcept {
  if (!command.pose.matrix().allFinite())
    return make_report(ErrorClass::non_fatal, ErrorCode::not_finite, "a value of the pose");
  if (!command.twist.allFinite())
    return make_report(ErrorClass::non_fatal, ErrorCode::not_finite, "a value of the twist");
  const Eigen::Matrix3d rotation = command.pose.linear();
  if (!(rotation.transpose() * rotation).isIdentity(kOrthogonality) || rotation.determinant() < 0)
    return make_report(ErrorClass::non_fatal, ErrorCode::invalid_argument, "the pose's orientation is not a rotation");

  const Pose target = command.relative ? Pose(kinematics_.direct(from.position) * command.pose) : command.pose;
  const ErrorCode code = kinematics_.inverse(target, from.position, to.position);
  if (code != ErrorCode::none && code != ErrorCode::singular)
    return make_report(ErrorClass::non_fatal, code, "position (%.4g, %.4g, %.4g)", target.translation().x(),
                       target.translation().y(), target.translation().z());
  if (to.position.size() != kinematics_.model().joint_count() || !to.position.allFinite())
    return make_report(ErrorClass::non_fatal, ErrorCode::out_of_workspace, "the inverse kinematics has no solution");
  if ((command.twist.array() == 0.0).all()) return {};

  const Jacobian jacobian = kinematics_.jacobian(to.position);
  const Eigen::CompleteOrthogonalDecomposition<Jacobian> decomposition(jacobian);
  to.velocity = decomposition.solve(command.twist);
  const double residual = (jacobian * to.velocity - command.twist).norm();
  if (!(residual <= kTwistResidual * std::max(1.0, command.twist.norm())))
    return make_report(ErrorClass::non_fatal, ErrorCode::singular,
                       "the robot cannot move with the twist there: %.4g of it is out of reach", residual);
  return {};
}

}  // namespace mrroc::edp
