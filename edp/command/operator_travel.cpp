#include "edp/command/operator_travel.hpp"

#include <algorithm>
#include <cmath>

#include "edp/safety/error_report.hpp"
#include "geometry/rigid_motion.hpp"

namespace mrroc::edp {

namespace {

constexpr double kMargin = 1.1;  // pieces of a path take a little more than the whole path

}  // namespace

OperatorTravel::OperatorTravel(const ModelSet& models, double period)
    : models_(models), period_(period), planner_(models.at(0), period) {}

ErrorReport OperatorTravel::plan(const RobotCommand& order, Effector& effector) noexcept {
  RobotState state;
  if (!effector.peek(state)) return make_report(ErrorClass::non_fatal, ErrorCode::busy, "the servo has not ticked yet");
  if (!state.at_rest()) return make_report(ErrorClass::non_fatal, ErrorCode::busy, "the robot moves");
  planner_.use(ToolKinematics(models_.at(effector.snapshot()->model), state.tool));
  planner_.stand_on(effector.snapshot()->switches);
  RobotCommand whole = order;
  whole.motion_steps = kSteps;
  whole.reply_step = 1;
  whole.joint_velocity.resize(0);
  whole.joint_acceleration.resize(0);
  whole.twist.setZero();
  whole.start_tick = 0;
  if (order.kind == CommandKind::pose && order.relative && !order.twist.isZero(0)) {
    whole.relative = false;
    whole.pose = state.desired_pose;
    whole.pose.translation() += order.twist.head<3>();
    whole.pose.linear() = exp_rotation(order.twist.tail<3>()) * state.desired_pose.linear();
  }
  const DesiredState from = DesiredState::resting_at(state.desired_joints);
  if (const ErrorReport error = planner_.plan(whole, from, Pace::stretched, path_); bad(error)) return error;
  slowness_ = kMargin;
  duration_ = static_cast<std::uint32_t>(std::ceil(path_.steps * slowness_));
  travelled_ = 0;
  return {};
}

ErrorReport OperatorTravel::write(RobotCommand& piece) noexcept {
  const std::uint32_t steps = std::min<std::uint32_t>(kSteps, duration_ - travelled_);
  piece_end_ = travelled_ + steps;
  const bool last = piece_end_ == duration_;
  piece = RobotCommand{};
  piece.kind = CommandKind::joint;
  piece.motion_steps = static_cast<std::uint16_t>(steps);
  piece.reply_step = static_cast<std::uint16_t>(last ? steps + 1 : std::max<std::uint32_t>(1, steps - 2));
  goal_ = path_.to;
  if (!last) {
    const double t = piece_end_ * period_ / slowness_;
    if (const ErrorCode code = path_.path.at(t, path_.from.position, goal_); code != ErrorCode::none)
      return make_report(ErrorClass::non_fatal, code, "on the path, at tick %u", piece_end_);
    piece.joint_velocity = goal_.velocity / slowness_;
    piece.joint_acceleration = goal_.acceleration / (slowness_ * slowness_);
  }
  piece.joints = goal_.position;
  return {};
}

void OperatorTravel::commanded() noexcept {
  path_.from.position = goal_.position;  // the inverse kinematics continues from there
  travelled_ = piece_end_;
}

}  // namespace mrroc::edp
