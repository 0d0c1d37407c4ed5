#include "language/limit_check.hpp"

#include <algorithm>
#include <cmath>

#include "language/limits.hpp"

namespace mrroc {
namespace {

constexpr std::uint32_t kSamples = 8;     // per macrostep, at least
constexpr std::uint32_t kMotorTicks = 8;  // from check to check in a stop, whose motors move smoothly
constexpr double kOutside = 1e-3;         // of the tolerance
constexpr double kRatioGrowth = 4;        // no transmission ratio grows more than that during one stop

}  // namespace

LimitCheck::LimitCheck(const RobotModel& model, double period)
    : model_(&model), period_(period), stop_(model.parameters(), period) {}

void LimitCheck::use(const RobotModel& model) noexcept {
  model_ = &model;
  stop_.use(model.parameters());
}

ErrorReport LimitCheck::violation(ErrorCode code, int axis, double tick, const char* what, double value,
                                  double limit) const noexcept {
  const int digits = digits_to_differ(std::abs(value), std::abs(limit));
  return make_report(ErrorClass::non_fatal, code, "axis %d (%s), tick %.4g: %s %.*g, limit %.*g", axis + 1,
                     axes()[static_cast<std::size_t>(axis)].name.c_str(), tick, what, digits, value, digits, limit);
}

void LimitCheck::widen(const DesiredState& from) noexcept {
  const int count = model_->joint_count();
  JointVector motors;
  const bool known = model_->joints_to_motors(from.position, motors) == ErrorCode::none;
  position_min_.resize(count), position_max_.resize(count), motor_min_.resize(count), motor_max_.resize(count);
  for (int i = 0; i < count; ++i) {
    const AxisParameters& axis = axes()[static_cast<std::size_t>(i)];
    const double joint = position_tolerance(axis.position_min, axis.position_max);
    const double motor = position_tolerance(axis.motor_min, axis.motor_max);
    // for a robot that is already outside: so much smaller than the tolerance that outward steps do not accumulate
    position_min_[i] = std::min(axis.position_min - joint, from.position[i] - kOutside * joint);
    position_max_[i] = std::max(axis.position_max + joint, from.position[i] + kOutside * joint);
    motor_min_[i] = axis.motor_min - motor, motor_max_[i] = axis.motor_max + motor;
    if (!known) continue;
    const double low = motors[i] - kOutside * motor, high = motors[i] + kOutside * motor;
    motor_min_[i] = switches_.on_lower(i) ? low : std::min(motor_min_[i], low);
    motor_max_[i] = switches_.on_upper(i) ? high : std::max(motor_max_[i], high);
  }
}

ErrorReport LimitCheck::check_state(const DesiredState& state, double tick) const noexcept {
  for (int i = 0; i < model_->joint_count(); ++i) {
    const AxisParameters& axis = axes()[static_cast<std::size_t>(i)];
    if (state.position[i] < position_min_[i])
      return violation(ErrorCode::joint_limit, i, tick, "position", state.position[i], axis.position_min);
    if (state.position[i] > position_max_[i])
      return violation(ErrorCode::joint_limit, i, tick, "position", state.position[i], axis.position_max);
    if (exceeds(state.velocity[i], axis.velocity_max))
      return violation(ErrorCode::velocity_limit, i, tick, "velocity", state.velocity[i], axis.velocity_max);
    if (exceeds(state.acceleration[i], axis.acceleration_max))
      return violation(ErrorCode::acceleration_limit, i, tick, "acceleration", state.acceleration[i],
                       axis.acceleration_max);
  }
  return {};
}

ErrorReport LimitCheck::check_motors(const JointVector& joints, double tick, const char* where) noexcept {
  if (model_->joints_to_motors(joints, motors_) != ErrorCode::none)
    return make_report(ErrorClass::non_fatal, ErrorCode::motor_limit, "tick %.4g: the transmission cannot reach %s",
                       tick, where);
  for (int i = 0; i < model_->joint_count(); ++i) {
    const AxisParameters& axis = axes()[static_cast<std::size_t>(i)];
    if (motors_[i] < motor_min_[i]) {
      if (switches_.on_lower(i)) return violation(ErrorCode::limit_switch, i, tick, where, motors_[i], motor_min_[i]);
      return violation(ErrorCode::motor_limit, i, tick, where, motors_[i], axis.motor_min);
    }
    if (motors_[i] > motor_max_[i]) {
      if (switches_.on_upper(i)) return violation(ErrorCode::limit_switch, i, tick, where, motors_[i], motor_max_[i]);
      return violation(ErrorCode::motor_limit, i, tick, where, motors_[i], axis.motor_max);
    }
  }
  return {};
}

ErrorReport LimitCheck::check_stop(const DesiredState& state, double tick) noexcept {
  stop_.plan(state);
  for (int i = 0; i < model_->joint_count(); ++i) {
    const AxisParameters& axis = axes()[static_cast<std::size_t>(i)];
    const AxisStop& stop = stop_.axis(i);
    if (stop.lowest() < position_min_[i])
      return violation(ErrorCode::joint_limit, i, tick, "a stop would reach", stop.lowest(), axis.position_min);
    if (stop.highest() > position_max_[i])
      return violation(ErrorCode::joint_limit, i, tick, "a stop would reach", stop.highest(), axis.position_max);
    if (exceeds(stop.fastest(), axis.velocity_max))
      return violation(ErrorCode::velocity_limit, i, tick, "a stop would reach the velocity", stop.fastest(),
                       axis.velocity_max);
  }
  return check_motors(stop_.end().position, tick, "motor position after a stop");
}

bool LimitCheck::motors_stay_clear() const noexcept {
  const JointMatrix ratio = model_->transmission(stop_.end().position);
  for (int i = 0; i < model_->joint_count(); ++i) {
    double way = 0;
    for (int j = 0; j < model_->joint_count(); ++j)
      way += std::abs(ratio(i, j)) * (stop_.axis(j).highest() - stop_.axis(j).lowest());
    way *= kRatioGrowth;
    if (!(motors_[i] - way > motor_min_[i] && motors_[i] + way < motor_max_[i])) return false;
  }
  return true;
}

ErrorReport LimitCheck::check_motors_of_stop(double tick) noexcept {
  for (std::uint32_t k = 1; k < stop_.ticks(); ++k)
    if (const ErrorReport report = check_motors(stop_.at(k * period_).position, tick + k, "motor position in a stop");
        bad(report))
      return report;
  return {};
}

ErrorReport LimitCheck::check_with_stop(const DesiredState& state, double tick) noexcept {
  if (const ErrorReport report = check_state(state, tick); bad(report)) return report;
  if (const ErrorReport report = check_motors(state.position, tick, "motor position"); bad(report)) return report;
  if (state.at_rest()) return {};
  if (const ErrorReport report = check_stop(state, tick); bad(report)) return report;
  return motors_stay_clear() ? ErrorReport{} : check_motors_of_stop(tick);
}

ErrorReport LimitCheck::check_between(const DesiredState& before, const DesiredState& after, double duration,
                                      double tick) const noexcept {
  for (int i = 0; i < model_->joint_count(); ++i) {
    const AxisParameters& axis = axes()[static_cast<std::size_t>(i)];
    const double velocity = (after.position[i] - before.position[i]) / duration;
    const double acceleration = (after.velocity[i] - before.velocity[i]) / duration;
    const double jerk = (after.acceleration[i] - before.acceleration[i]) / duration;
    if (exceeds(velocity, axis.velocity_max))
      return violation(ErrorCode::velocity_limit, i, tick, "mean velocity", velocity, axis.velocity_max);
    if (exceeds(acceleration, axis.acceleration_max))
      return violation(ErrorCode::acceleration_limit, i, tick, "mean acceleration", acceleration,
                       axis.acceleration_max);
    if (exceeds(jerk, axis.jerk_max, kJerkRounding))
      return violation(ErrorCode::jerk_limit, i, tick, "mean jerk", jerk, axis.jerk_max);
  }
  return {};
}

bool LimitCheck::passes(const CommonStopPath& stop) noexcept {
  DesiredState previous = stop.at(0);
  for (std::uint32_t k = 1; k <= stop.ticks(); ++k) {
    const DesiredState state = stop.at(k * period_);
    if (bad(check_state(state, k)) || bad(check_between(previous, state, period_, k))) return false;
    if ((k % kMotorTicks == 0 || k == stop.ticks()) && bad(check_motors(state.position, k, "motor position")))
      return false;
    previous = state;
  }
  return true;
}

std::uint32_t LimitCheck::samples_per_tick(const DesiredState& from, std::uint32_t steps,
                                           const Quintic* quintic) const noexcept {
  return quintic != nullptr && stays_clear(from, *quintic) ? 1 : (kSamples + steps - 1) / steps;
}

bool LimitCheck::stays_clear(const DesiredState& from, const Quintic& path) const noexcept {
  const Quintic::Bounds bounds = path.bounds();
  for (int i = 0; i < model_->joint_count(); ++i) {
    const AxisParameters& axis = axes()[static_cast<std::size_t>(i)];
    if (!(from.position[i] - bounds.position[i] > position_min_[i] &&
          from.position[i] + bounds.position[i] < position_max_[i] && bounds.velocity[i] < axis.velocity_max &&
          bounds.acceleration[i] < axis.acceleration_max && bounds.jerk[i] < axis.jerk_max))
      return false;
  }
  return true;
}

}  // namespace mrroc
