#include "language/motion_check.hpp"

#include <algorithm>
#include <cmath>

#include "language/limits.hpp"
#include "mrroc/task.hpp"

namespace mrroc {
namespace {

constexpr double kStepSumRounding = 1e-9;  // s: sums of step durations are not exact
constexpr double kIntervalGrowth = 4;      // a transmission ratio grows less than that in a skipped interval

/// m or rad that a stop takes at most from a velocity `v` and an acceleration `a`, both magnitudes.
double longest_stop(const AxisParameters& axis, double v, double a) noexcept {
  const double jerk = axis.jerk_max, highest = v + a * a / (2 * jerk);  // when the acceleration has become 0
  const double ramps = std::min(axis.acceleration_max / jerk, 2 * std::sqrt(highest / jerk));
  return highest * a / jerk + 0.5 * highest * (highest / axis.acceleration_max + ramps);
}

}  // namespace

MotionCheck::MotionCheck(const Robot& robot)
    : robot_(&robot), model_(&robot.kinematics().model()), limits_(*model_, robot.task().servo_period()) {}

ErrorReport MotionCheck::check(const States& states, double duration, double& start, MotionPace pace) {
  if (!robot_->state().synchronised) return {};
  pace_ = pace;
  model_ = &robot_->kinematics().model();
  limits_.use(*model_);
  states_ = &states;
  step_ = robot_->step_duration();
  duration_ = duration;
  macrosteps_ = static_cast<std::int64_t>(std::ceil(duration / step_ - kStepSumRounding / step_));
  if (macrosteps_ < 1) return {};
  const ErrorReport report = check_interval(0, macrosteps_, state(0), state(macrosteps_));
  start = step_ * static_cast<double>(reported_);
  return report;
}

void MotionCheck::require(const States& states, double duration, MotionPace pace) {
  double start = 0;
  const ErrorReport report = check(states, duration, start, pace);
  if (!bad(report)) return;
  throw NonFatalError(report.code,
                      std::string{report.detail.view()} + ", " + std::to_string(start) + " s after the start",
                      {robot_->task().process_name(), robot_->name(), 0, robot_->state().tick});
}

DesiredState MotionCheck::state(std::int64_t macrostep) const {
  const double time = step_ * static_cast<double>(macrostep);
  if (macrostep < macrosteps_) return (*states_)(time);
  return DesiredState::resting_at((*states_)(duration_).position);
}

ErrorReport MotionCheck::check_interval(std::int64_t first, std::int64_t last, const DesiredState& from,
                                        const DesiredState& to) {
  if (is_clear(first, last, from, to)) return {};
  if (last - first == 1) {
    reported_ = first;
    return check_macrostep(from, to);
  }
  const std::int64_t middle = first + (last - first) / 2;
  const DesiredState between = state(middle);
  if (const ErrorReport report = check_interval(first, middle, from, between); bad(report)) return report;
  return check_interval(middle, last, between, to);
}

ErrorReport MotionCheck::check_macrostep(const DesiredState& from, const DesiredState& to) {
  Quintic quintic;
  quintic.plan(from, to, step_);
  return limits_.check(from, to, robot_->motion_steps(), &quintic,
                       [&quintic](double t, const JointVector&, DesiredState& state) noexcept {
                         state = quintic.at(t);
                         return ErrorCode::none;
                       });
}

bool MotionCheck::is_clear(std::int64_t first, std::int64_t last, const DesiredState& from,
                           const DesiredState& to) const {
  const double time = step_ * static_cast<double>(last - first);
  const double speed = step_ * static_cast<double>(first) < pace_.from ? 1 : pace_.speed;
  const auto& axes = model_->parameters().axes;
  const JointVector middle = 0.5 * (from.position + to.position);
  JointVector reach(middle.size()), motors;
  for (Eigen::Index i = 0; i < middle.size(); ++i) {
    const AxisParameters& axis = axes[static_cast<std::size_t>(i)];
    const double way = std::abs(to.position[i] - from.position[i]);
    const double ends = std::max(std::abs(from.velocity[i]), std::abs(to.velocity[i]));
    const double a = speed * speed * axis.acceleration_max;
    const double v = std::min(speed * axis.velocity_max, ends + 0.5 * a * time);
    reach[i] = std::min(0.5 * v * time, 0.5 * way + 0.125 * a * time * time) + longest_stop(axis, v, a);
    const double tolerance = position_tolerance(axis.position_min, axis.position_max);
    if (middle[i] - reach[i] < axis.position_min - tolerance || middle[i] + reach[i] > axis.position_max + tolerance)
      return false;
  }
  if (model_->joints_to_motors(middle, motors) != ErrorCode::none) return false;
  const JointVector way = kIntervalGrowth * (model_->transmission(middle).cwiseAbs() * reach);
  for (Eigen::Index i = 0; i < motors.size(); ++i) {
    const AxisParameters& axis = axes[static_cast<std::size_t>(i)];
    if (!(motors[i] - way[i] > axis.motor_min && motors[i] + way[i] < axis.motor_max)) return false;
  }
  // a transmission that reaches only a part of the box of joint limits, as one with passive joints
  JointVector corner = middle;
  for (Eigen::Index i = 0; i < middle.size(); ++i) {
    for (const double side : {-kIntervalGrowth, kIntervalGrowth}) {
      corner[i] = middle[i] + side * reach[i];
      if (model_->joints_to_motors(corner, motors) != ErrorCode::none) return false;
    }
    corner[i] = middle[i];
  }
  return true;
}

}  // namespace mrroc
