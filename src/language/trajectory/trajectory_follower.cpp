#include "language/trajectory/trajectory_follower.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error_report.hpp"
#include "geometry/quintic.hpp"
#include "language/limits.hpp"
#include "mrroc/generators/external.hpp"
#include "mrroc/task.hpp"

namespace mrroc {

namespace {

constexpr double kReserve = 0.05;        // of each limit: what the deviation has at least
constexpr double kMeanVelocity = 1.001;  // of the limit: what numbers of few digits may exceed it by
constexpr double kOn = 1e-9;             // rad or m: on the trajectory

std::vector<AxisTracker> trackers_of(const Robot& robot) {
  std::vector<AxisTracker> axes;
  for (std::size_t i = 0; i < robot.parameters().axes.size(); ++i) axes.emplace_back(robot.step_duration());
  return axes;
}

/// A motion in own time, as the clock sees it.
AxisMotion scaled(const AxisMotion& own, TimeScale scale) {
  return {own.position, scale.factor * own.velocity,
          scale.factor * scale.factor * own.acceleration + scale.rate * own.velocity};
}

DesiredState desired_of(const Robot& robot) {
  const RobotState& state = robot.state();
  return {state.desired_joints, state.desired_velocity, state.desired_acceleration};
}

template <class... Numbers>
ErrorReport refusal(ErrorCode code, const char* format, Numbers... numbers) noexcept {
  return make_report(ErrorClass::non_fatal, code, format, numbers...);
}

}  // namespace

TrajectoryFollower::TrajectoryFollower(Robot& robot)
    : robot_(&robot),
      limits_(*robot.models().front(), robot.task().servo_period()),
      tracker_(robot),
      step_(robot.step_duration()),
      axes_(trackers_of(robot)) {
  trajectory_.reserve(axes_.size());
  reference_ = goal_ = DesiredState::resting_at(JointVector::Zero(static_cast<Eigen::Index>(axes_.size())));
}

ErrorReport TrajectoryFollower::check(const JointTrajectory& trajectory) const noexcept {
  const auto& axes = robot_->parameters().axes;
  const RobotModel& model = robot_->kinematics().model();
  JointVector joints = robot_->state().desired_joints, motors = joints;
  if (!robot_->state().synchronised) return refusal(ErrorCode::not_synchronised, "the robot has no joints yet");
  double before = 0;
  for (std::size_t point = 0; point < trajectory.points(); ++point) {
    const double duration = trajectory.time(point) - before;
    before = trajectory.time(point);
    for (std::size_t i = 0; i < axes.size(); ++i) {
      const auto axis = static_cast<Eigen::Index>(i);
      const double position = trajectory.position(point, i), way = std::abs(position - joints[axis]);
      const char* const name = axes[i].name.c_str();
      const auto [min, max] = std::pair(axes[i].position_min, axes[i].position_max);
      if (!is_within(position, min, max)) {
        const int digits = digits_to_differ(position, min, max);
        return refusal(ErrorCode::joint_limit, "point %zu: joint %s at %.*g, expected %.*g to %.*g", point, name,
                       digits, position, digits, min, digits, max);
      }
      if (duration <= 0 && way > External::kStart)
        return refusal(ErrorCode::invalid_argument, "point 0 at time 0: joint %s %.*g from the robot, expected %g",
                       name, digits_to_differ(way, External::kStart), way, External::kStart);
      if (const double most = axes[i].velocity_max; duration > 0 && way > kMeanVelocity * most * duration)
        return refusal(ErrorCode::velocity_limit, "point %zu: joint %s needs a velocity of %.6g, limit %.6g", point,
                       name, way / duration, most);
      joints[axis] = position;
    }
    if (model.joints_to_motors(joints, motors) != ErrorCode::none)
      return refusal(ErrorCode::motor_limit, "point %zu: the transmission cannot reach it", point);
    for (std::size_t i = 0; i < axes.size(); ++i) {
      const double motor = motors[static_cast<Eigen::Index>(i)], min = axes[i].motor_min, max = axes[i].motor_max;
      if (is_within(motor, min, max)) continue;
      const int digits = digits_to_differ(motor, min, max);
      return refusal(ErrorCode::motor_limit, "point %zu: motor %s at %.*g, expected %.*g to %.*g rad", point,
                     axes[i].name.c_str(), digits, motor, digits, min, digits, max);
    }
  }
  return {};
}

void TrajectoryFollower::begin(JointTrajectory& trajectory) noexcept {
  trajectory_.swap(trajectory);
  pieces_.begin(trajectory_, desired_of(*robot_));
  ramp_.set(1);
  time_ = 0;
  landed_ = false;
}

double TrajectoryFollower::ramp_duration(const JointVector& speed) const noexcept {
  double duration = step_;
  for (std::size_t i = 0; i < axes_.size(); ++i) {  // half of the limits: the trajectory itself needs a part
    const AxisParameters& limits = robot_->parameters().axes[i];
    const double v = std::abs(speed[static_cast<Eigen::Index>(i)]);
    duration = std::max({duration, 3 * v / limits.acceleration_max, std::sqrt(12 * v / limits.jerk_max)});
  }
  return step_ * std::ceil(duration / step_);
}

void TrajectoryFollower::brake() noexcept {
  if (ramp_.goal() != 0) ramp_.lead_to(0, ramp_duration(robot_->state().desired_velocity));
}

void TrajectoryFollower::go_on() noexcept {
  JointVector speed = robot_->state().desired_velocity;
  for (std::size_t i = 0; i < axes_.size(); ++i)
    speed[static_cast<Eigen::Index>(i)] = robot_->parameters().axes[i].velocity_max;
  ramp_.set(0);
  ramp_.lead_to(1, ramp_duration(speed));
}

void TrajectoryFollower::step() {
  if (const double step = robot_->step_duration(); step != step_) {  // allocates at the first one of another length
    step_ = step;
    axes_ = trackers_of(*robot_);
  }
  const TimeScale before = ramp_.scale();
  double own = ramp_.advance(step_);
  const double end = trajectory_.duration();
  if (time_ < end && time_ + own > end) own = end - time_;
  if (!command_exactly(own, before)) track();
  time_ += own;
}

/// On the polynomial in which the step ends: the deviation jumps where the trajectory does.
bool TrajectoryFollower::command_exactly(double own_step, TimeScale before) {
  const RobotState& from = robot_->state();
  const TimeScale after = ramp_.scale();
  const double end = time_ + own_step;
  const std::size_t piece = pieces_.piece_at(end);
  const bool last = end >= trajectory_.duration();
  landed_ = true;
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    const AxisParameters& limits = robot_->parameters().axes[i];
    const AxisMotion start = scaled(pieces_.at(piece, i, time_), before);
    AxisMotion to = scaled(pieces_.at(piece, i, end), after);
    if (last) to.velocity = to.acceleration = 0;
    reference_.position[axis] = start.position;
    reference_.velocity[axis] = (to.position - start.position) / step_;
    const AxisMotion off{from.desired_joints[axis] - start.position, from.desired_velocity[axis] - start.velocity,
                         from.desired_acceleration[axis] - start.acceleration};
    const auto left = [](double limit, double used) { return std::max(kReserve * limit, limit - used); };
    const AxisBounds bounds{
        left(limits.velocity_max, std::max(std::abs(start.velocity), std::abs(to.velocity))),
        left(limits.acceleration_max, std::max(std::abs(start.acceleration), std::abs(to.acceleration))),
        left(limits.jerk_max, std::abs(to.acceleration - start.acceleration) / step_)};
    AxisMotion rest = axes_[i].after(off, axes_[i].jerk(off, bounds));
    const bool on =
        std::abs(rest.position) < kOn && std::abs(rest.velocity) < kOn && std::abs(rest.acceleration) < 1e-7;
    if (on) rest = {};
    landed_ = landed_ && on && to.velocity == 0 && to.acceleration == 0;
    goal_.position[axis] = to.position + rest.position;
    goal_.velocity[axis] = to.velocity + rest.velocity;
    goal_.acceleration[axis] = to.acceleration + rest.acceleration;
  }
  if (!is_allowed(goal_)) return false;
  RobotCommand& command = robot_->command();
  command.kind = CommandKind::joint;
  command.joints = goal_.position;
  command.joint_velocity = goal_.velocity;
  command.joint_acceleration = goal_.acceleration;
  return true;
}

void TrajectoryFollower::track() {
  landed_ = false;
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    const AxisParameters& limits = robot_->parameters().axes[i];
    const double fastest = 0.9 * limits.velocity_max;
    reference_.position[axis] = std::clamp(reference_.position[axis], limits.position_min, limits.position_max);
    reference_.velocity[axis] = std::clamp(reference_.velocity[axis], -fastest, fastest);
  }
  // a target whose velocity changes may lead beyond a limit, one at rest does not
  RobotCommand& command = robot_->command();
  const auto allowed = [&] { return is_allowed({command.joints, command.joint_velocity, command.joint_acceleration}); };
  tracker_.to(reference_.position, reference_.velocity);
  if (allowed()) return;
  tracker_.to(reference_.position);
  if (!allowed()) robot_->reset_command(CommandKind::hold);
}

bool TrajectoryFollower::is_allowed(const DesiredState& to) noexcept {
  const DesiredState from = desired_of(*robot_);
  Quintic quintic;
  quintic.plan(from, to, step_);
  limits_.use(robot_->kinematics().model());
  return !bad(limits_.check(from, to, robot_->motion_steps(), &quintic,
                            [&quintic](double t, const JointVector&, DesiredState& state) noexcept {
                              state = quintic.at(t);
                              return ErrorCode::none;
                            }));
}

int TrajectoryFollower::off_path(double& distance) const noexcept {
  const RobotState& state = robot_->state();
  const double ahead = state.desired_tick > state.tick
                           ? static_cast<double>(state.desired_tick - state.tick) * robot_->task().servo_period()
                           : 0;
  const double then = std::max(0.0, time_ - ramp_.scale().factor * ahead);
  const std::size_t piece = pieces_.piece_at(then);
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    distance = state.joints[static_cast<Eigen::Index>(i)] - pieces_.at(piece, i, then).position;
    const double tolerance = trajectory_.path_tolerance(i);
    if (tolerance > 0 && std::abs(distance) > tolerance) return static_cast<int>(i);
  }
  return -1;
}

int TrajectoryFollower::off_goal(double& distance) const noexcept {
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    distance = robot_->state().joints[static_cast<Eigen::Index>(i)] - trajectory_.position(trajectory_.points() - 1, i);
    const double tolerance = trajectory_.goal_tolerance(i);
    if (tolerance > 0 && std::abs(distance) > tolerance) return static_cast<int>(i);
  }
  return -1;
}

}  // namespace mrroc
