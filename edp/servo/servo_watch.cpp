// The servo's measurements, and the faults for which it stops the robot.
#include <algorithm>
#include <cmath>
#include <limits>

#include "edp/servo/servo.hpp"
#include "language/limits.hpp"

namespace mrroc::edp {
namespace {

// the planner has checked the limits; this guard catches only errors that the planner cannot detect
constexpr double kGuard = 2;        // of the planner's tolerance of positions
constexpr double kRounding = 1e-6;  // of velocities
constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

}  // namespace

void Servo::widen_limits() noexcept {
  for (int i = 0; i < model_->joint_count(); ++i) {
    const AxisParameters& axis = model_->parameters().axes[static_cast<std::size_t>(i)];
    const double beyond = kGuard * position_tolerance(axis.position_min, axis.position_max);
    position_min_[i] = std::min(axis.position_min, joints_[i]) - beyond;
    position_max_[i] = std::max(axis.position_max, joints_[i]) + beyond;
  }
}

void Servo::measure(Tick tick, double measured) noexcept {
  elapsed_ = ticked_ ? now_ - then_ : 1;
  const double last_read = input_.time;
  input_.time = measured;
  input_.late = 0;
  input_.unseen = 0;
  input_.motors.setConstant(kNothing);
  input_.current.setConstant(kNothing);
  input_.fault_axis = -1;
  input_.fault_detail = {};
  hardware_.read(tick, input_);
  found_ = {};
  urgent_ = false;
  find_fault({input_.fault, input_.fault_axis, input_.fault_detail});
  check_encoders();
  if (!ticked_) {
    last_ = tick == 0 ? 0 : tick - 1;
    then_ = static_cast<double>(last_);
    measured_motors_ = desired_motors_ = input_.motors;
    if (!use(input_.synchronised ? 0 : ModelSet::kShafts)) find_fault({ErrorCode::motor_limit});
  } else if (!input_.synchronised && model_index_ != ModelSet::kShafts) {
    find_fault({ErrorCode::drive_fault});  // the drives have lost their positions
  }
  JointVector joints = joints_;
  if (model_->motors_to_joints(input_.motors, joints) != ErrorCode::none) {
    joints = joints_;
    find_fault({ErrorCode::motor_limit});
  }
  if (emergency_.check(input_.inputs)) find_fault({ErrorCode::emergency_stop});
  if (ticked_) {
    measured_increment_ = input_.motors - measured_motors_;
    if (input_.time > last_read)  // else it is a repeated reading
      velocity_ = (joints - read_joints_) / (period_ * (input_.time - last_read));
  }
  if (!ticked_ || input_.time > last_read) read_joints_ = joints;
  measured_motors_ = input_.motors;
  joints_ = joints;
  ++counters_.ticks;
  if (tick > last_ + 1) counters_.missed += tick - last_ - 1;
}

/// Implausible positions and currents are replaced by the last valid ones.
void Servo::check_encoders() noexcept {
  if (found_.code != ErrorCode::hardware_silent || !input_.motors.allFinite()) {
    const EncoderWatch::Finding finding = encoders_.check(input_.motors, input_.time, now_);
    if (finding.axis >= 0) {
      find_fault({ErrorCode::encoder_fault, finding.axis, finding.detail});
      input_.motors = measured_motors_;
    }
  }
  for (Eigen::Index i = 0; i < input_.current.size(); ++i) {
    if (std::isfinite(input_.current[i])) continue;
    find_fault({ErrorCode::drive_fault, static_cast<int>(i), NotFinite{}});
    input_.current[i] = 0;
  }
}

/// A fault in the readings stops the robot like one that the drives report; the more severe one counts.
void Servo::find_fault(const Fault& fault) noexcept {
  urgent_ = urgent_ || (fault.code != ErrorCode::none && is_urgent(fault.code));
  if (graver(fault.code, found_.code)) found_ = fault;
}

void Servo::watch(Tick tick) noexcept {
  const bool moves = state_ == ServoState::on;
  const Fault in_motion = find_in_motion();
  if (moves) find_fault(in_motion);
  if (has_power(state_)) {
    const bool given = hardware_.follows_current();
    find_fault(motion_.check(
        *model_, {joints_, velocity_, measured_motors_, desired_motors_, given ? current_ : input_.current, given},
        {input_.time, input_.late, input_.unseen}, moves, homing_axis()));
  }
  if (found_.code != ErrorCode::none) latch(found_, tick);
  if (has_power(state_) && fault_.code != ErrorCode::none)
    stop(found_.code != ErrorCode::none ? found_.code : fault_.code, tick);
  if (state_ == ServoState::on) stop_with_group(tick);
  if (force_.present()) watch_force(tick);
}

/// Checks that apply while the drives are on and stay on; counts in every state.
Fault Servo::find_in_motion() noexcept {
  const bool moves = state_ == ServoState::on;
  const std::vector<AxisParameters>& axes = model_->parameters().axes;
  const int axis = switches_.check(input_, desired_motors_ - previous_motors_,
                                   moves ? synchronised_axis() : LimitSwitchWatch::kEvery);
  if (!moves) return {};
  for (int i = 0; i < model_->joint_count(); ++i) {
    const double error = std::abs(desired_motors_[i] - measured_motors_[i]);
    const double limit = axes[static_cast<std::size_t>(i)].following_error_max;
    counters_.following_error[i] = std::max(counters_.following_error[i], error);
    if (!(error <= limit)) return {ErrorCode::following_error, i, Excess{error, limit}};
  }
  if (axis >= 0) return {ErrorCode::limit_switch, axis, ShaftPosition{measured_motors_[axis]}};
  const int hot = currents_.check(input_.current, elapsed_);
  if (hot < 0) return {};
  return {ErrorCode::over_current, hot, Excess{input_.current[hot], axes[static_cast<std::size_t>(hot)].current_max}};
}

void Servo::watch_force(Tick tick) noexcept {
  const bool synchronised = model_index_ != ModelSet::kShafts;
  const Pose flange = synchronised ? model_->flange(joints_) : Pose::Identity();
  force_.read(tick, synchronised ? &flange : nullptr);
  ForceWatch::Doing doing = ForceWatch::Doing::resting;
  // between two macrosteps of a motion none is under way, and the robot moves
  if (state_ == ServoState::on && (running_ || !desired_.at_rest())) {
    if (active_.kind == Macrostep::Kind::path) doing = ForceWatch::Doing::moving;
    if (active_.kind == Macrostep::Kind::force) doing = ForceWatch::Doing::following;
  }
  const Pose set_point = synchronised ? model_->flange(desired_.position) : Pose::Identity();
  const ErrorReport report = force_.check(doing, set_point);
  if (report.error_class == ErrorClass::none || postponed_.error_class != ErrorClass::none) return;
  if (doing == ForceWatch::Doing::moving && group_.is_shared() && moves_in_group()) {
    postponed_ = report;
    group_.announce(active_.stop.group, tick);
  } else {
    interrupt(report, then_, tick);
  }
}

void Servo::latch(const Fault& fault, Tick tick) noexcept {
  if (fault_.code != ErrorCode::none) return;
  fault_ = fault;
  fault_.tick = tick;
}

bool Servo::keeps_limits(Tick tick) noexcept {
  if (model_->joints_to_motors(desired_.position, desired_motors_) != ErrorCode::none) {
    latch({ErrorCode::motor_limit}, tick);
    return state_ == ServoState::stopping;
  }
  if (state_ == ServoState::stopping) return true;  // the stop is the best remaining reaction
  const int homing = homing_axis();
  for (int i = 0; i < model_->joint_count(); ++i) {
    if (i == homing) continue;  // the set-point is where the drive has brought it
    const AxisParameters& axis = model_->parameters().axes[static_cast<std::size_t>(i)];
    const double position = desired_.position[i];
    const double velocity = (position - previous_position_[i]) / (period_ * elapsed_);
    if (!(position >= position_min_[i])) latch({ErrorCode::joint_limit, i, Excess{position, axis.position_min}}, tick);
    if (!(position <= position_max_[i])) latch({ErrorCode::joint_limit, i, Excess{position, axis.position_max}}, tick);
    if (!(std::abs(velocity) <= axis.velocity_max * (1 + kRounding) + kRounding))
      latch({ErrorCode::velocity_limit, i, Excess{velocity, axis.velocity_max}}, tick);
  }
  return fault_.code == ErrorCode::none;
}

}  // namespace mrroc::edp
