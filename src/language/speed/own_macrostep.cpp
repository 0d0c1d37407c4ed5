#include "language/speed/own_macrostep.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mrroc/task.hpp"

namespace mrroc {

namespace {

constexpr double kHaltShare = 0.7;  // of the limits, for a change of the speed in motion at constant velocity
constexpr double kRefusedLoad = 10;
constexpr std::uint16_t kLeastLoadSamples = 8;
constexpr double kOwnEnd = 1e-9;  // s: at its end

}  // namespace

OwnMacrostep::OwnMacrostep(Robot& robot)
    : robot_(&robot), limits_(robot.kinematics().model(), robot.task().servo_period()) {}

double OwnMacrostep::period() const noexcept { return robot_->task().servo_period(); }

DesiredState OwnMacrostep::own_state(TimeScale scale) const noexcept {
  const RobotState& state = robot_->state();
  if (kind_ == Kind::path) return end_;
  if (kind_ == Kind::real_time) return {state.desired_joints, state.desired_velocity, state.desired_acceleration};
  return unscaled(scale);
}

DesiredState OwnMacrostep::unscaled(TimeScale scale) const noexcept {
  const RobotState& state = robot_->state();
  const double s = scale.factor;
  if (state.at_rest() || s == 0) return DesiredState::resting_at(state.desired_joints);
  const JointVector velocity = state.desired_velocity / s;
  return {state.desired_joints, velocity, (state.desired_acceleration - scale.rate * velocity) / (s * s)};
}

void OwnMacrostep::show(TimeScale scale) noexcept {
  RobotState& state = robot_->exchanged_state();
  hidden_ = {state.desired_joints, state.desired_velocity, state.desired_acceleration};
  hidden_pose_ = state.desired_pose;
  const DesiredState own = own_state(scale);
  state.desired_joints = own.position;
  state.desired_velocity = own.velocity;
  state.desired_acceleration = own.acceleration;
  if (kind_ != Kind::path) return;
  state.desired_pose = command_.kind == CommandKind::pose ? goal_.tool.pose : robot_->kinematics().direct(own.position);
}

void OwnMacrostep::hide() noexcept {
  RobotState& state = robot_->exchanged_state();
  state.desired_joints = hidden_.position;
  state.desired_velocity = hidden_.velocity;
  state.desired_acceleration = hidden_.acceleration;
  state.desired_pose = hidden_pose_;
}

void OwnMacrostep::take(TimeScale scale) noexcept {
  from_ = own_state(scale);
  command_ = robot_->command();
  switch (command_.kind) {
    case CommandKind::joint:
    case CommandKind::pose:
    case CommandKind::motor: {
      kind_ = Kind::refused;
      if (!robot_->state().synchronised) return;
      const ToolKinematics kinematics = robot_->kinematics();
      const double duration = command_.motion_steps * period();
      if (bad(read_goal(command_, from_, kinematics, duration, period(), goal_))) return;
      if (plan_to(goal_, command_.interpolation, kinematics, from_, duration, period(), path_, end_) == ErrorCode::none)
        kind_ = Kind::path;
      return;
    }
    case CommandKind::joint_velocity:
    case CommandKind::twist:
      kind_ = Kind::velocity;
      return;
    default:
      kind_ = Kind::real_time;
  }
}

void OwnMacrostep::remember(TimeScale scale) noexcept {
  robot_->time_scale() = kind_ == Kind::path || kind_ == Kind::velocity ? scale : TimeScale{};
}

DesiredState OwnMacrostep::piece_end(double time, TimeScale scale) const noexcept {
  DesiredState state = end_;
  const double duration = command_.motion_steps * period();
  if (time > duration - kOwnEnd && (end_.at_rest() || time < duration + kOwnEnd)) {
    if (end_.at_rest()) return end_;
  } else {
    path_.at(time, robot_->state().desired_joints, state);
  }
  const double s = scale.factor;
  state.acceleration = s * s * state.acceleration + scale.rate * state.velocity;
  state.velocity *= s;
  return state;
}

void OwnMacrostep::command(double time, TimeScale scale, std::uint16_t ticks, bool first) noexcept {
  RobotCommand& command = robot_->command();
  if (kind_ == Kind::path) {
    robot_->reset_command(CommandKind::joint);
    const DesiredState state = piece_end(time, scale);
    command.joints = state.position;
    if (!state.at_rest()) {
      command.joint_velocity = state.velocity;
      command.joint_acceleration = state.acceleration;
    }
    command.start_tick = command_.start_tick;
    command.with_outputs = command_.with_outputs;
    command.outputs = command_.outputs;
  } else {
    command = command_;
    if (kind_ == Kind::velocity) {
      command.joint_velocity *= scale.factor;
      command.twist *= scale.factor;
      command.twist_acceleration *= scale.factor * scale.factor;
    }
  }
  if (!first) {
    command.start_tick = 0;
    command.with_outputs = false;
  }
  const int after = command_.motion_steps - command_.reply_step;  // ticks that the reply leaves for the next command
  command.motion_steps = ticks;
  command.reply_step = static_cast<std::uint16_t>(after < 0 ? ticks + 1 : std::max(ticks - after, 1));
}

RampBounds OwnMacrostep::halt_bounds(TimeScale scale) const noexcept {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  RampBounds bounds{kInfinity, kInfinity};
  if (kind_ != Kind::path) return bounds;
  const JointVector now = unscaled(scale).velocity;
  for (Eigen::Index i = 0; i < now.size(); ++i) {
    const AxisParameters& axis = robot_->parameters().axes[static_cast<std::size_t>(i)];
    const double velocity = std::max(std::abs(now[i]), std::abs(end_.velocity[i]));
    if (velocity == 0) continue;
    bounds.rate = std::min(bounds.rate, kHaltShare * axis.acceleration_max / velocity);
    bounds.change = std::min(bounds.change, kHaltShare * axis.jerk_max / velocity);
  }
  return bounds;
}

double OwnMacrostep::load(double time, TimeScale scale, std::uint16_t ticks) noexcept {
  if (kind_ != Kind::path) return 0;
  const RobotModel& model = robot_->kinematics().model();
  const RobotState& state = robot_->state();
  const DesiredState from{state.desired_joints, state.desired_velocity, state.desired_acceleration};
  const DesiredState to = piece_end(time, scale);
  const double duration = ticks * period();
  Quintic quintic;
  quintic.plan(from, to, duration);
  limits_.use(model);
  const ErrorReport report =
      limits_.check(from, to, ticks, &quintic, [&quintic](double t, const JointVector&, DesiredState& at) noexcept {
        at = quintic.at(t);
        return ErrorCode::none;
      });
  double largest = bad(report) ? kRefusedLoad : 0;
  const int samples = std::max(ticks, kLeastLoadSamples);
  JointVector before = from.acceleration;
  for (int k = 1; k <= samples; ++k) {
    const JointVector now = quintic.at(duration * k / samples).acceleration;
    for (Eigen::Index i = 0; i < now.size(); ++i) {
      const AxisParameters& axis = model.parameters().axes[static_cast<std::size_t>(i)];
      largest = std::max({largest, std::abs(now[i]) / axis.acceleration_max,
                          std::abs(now[i] - before[i]) * samples / (duration * axis.jerk_max)});
    }
    before = now;
  }
  return largest;
}

}  // namespace mrroc
