#include "edp/servo.hpp"

#include <algorithm>
#include <cmath>

namespace mrroc::edp {
namespace {

constexpr double kRounding = 1e-6;  // the planner has checked the limits; this guard only meets what it cannot see

}  // namespace

Servo::Servo(const ModelSet& models, Hardware& hardware, double period, HandOver& hand_over)
    : models_(models),
      model_(&models.at(0)),
      hardware_(hardware),
      period_(period),
      hand_over_(hand_over),
      stop_(models.parameters(), period),
      synchroniser_(models.parameters(), models.at(ModelSet::kShafts).parameters(), period),
      force_motion_(models.at(0), period) {
  const int count = model_->joint_count();
  for (const AxisParameters& axis : models.parameters().axes) regulators_.emplace_back(axis);
  const JointVector zero = JointVector::Zero(count);
  joints_ = velocity_ = measured_motors_ = measured_increment_ = current_ = zero;
  desired_motors_ = previous_position_ = previous_motors_ = position_min_ = position_max_ = zero;
  input_.motors = input_.current = zero;
  desired_ = DesiredState::resting_at(zero);
  counters_.following_error = zero;
}

void Servo::use_force_sensor(ForceSensor& sensor, const ForceLimits& limits) noexcept { force_.use(sensor, limits); }

/// The robot rests: the same shafts, seen as joints of another model. False: they are no joints of that model.
bool Servo::use(std::uint8_t index) noexcept {
  const RobotModel& model = models_.at(index);
  JointVector joints, desired;
  if (model.motors_to_joints(measured_motors_, joints) != ErrorCode::none) return false;
  if (model.motors_to_joints(desired_motors_, desired) != ErrorCode::none) return false;
  model_ = &model;
  model_index_ = index;
  stop_.use(model.parameters());
  force_motion_.use(model);
  joints_ = joints;
  velocity_.setZero();
  desired_ = DesiredState::resting_at(desired);
  previous_position_ = desired;
  widen_limits();
  ++epoch_;
  return true;
}

void Servo::widen_limits() noexcept {
  for (int i = 0; i < model_->joint_count(); ++i) {
    const AxisParameters& axis = model_->parameters().axes[static_cast<std::size_t>(i)];
    position_min_[i] = std::min(axis.position_min, joints_[i]) - kRounding;
    position_max_[i] = std::max(axis.position_max, joints_[i]) + kRounding;
  }
}

bool Servo::tick(Tick tick) noexcept {
  measure(tick);
  obey_order();
  watch(tick);
  if (enabled_) {
    previous_position_ = desired_.position;
    previous_motors_ = desired_motors_;
    const DesiredState before = desired_;
    const RobotModel* const model = model_;
    advance(tick);
    if (!keeps_limits(tick)) {
      if (model_ == model) desired_ = before;
      boundary_ = last_;
      stop_and_switch_off();
      advance(tick);
      model_->joints_to_motors(desired_.position, desired_motors_);
    }
    regulate();
    if (stopping_ && !running_) {
      hardware_.enable(false);
      enabled_ = stopping_ = false;
      current_.setZero();
    }
  } else {
    refuse_foreign();
    desired_ = DesiredState::resting_at(joints_);
    desired_motors_ = measured_motors_;
  }
  hardware_.write(tick, current_);
  return publish(tick);
}

void Servo::measure(Tick tick) noexcept {
  elapsed_ = ticked_ ? tick - last_ : 1;
  hardware_.read(tick, input_);
  if (!ticked_) {
    last_ = tick == 0 ? 0 : tick - 1;
    measured_motors_ = desired_motors_ = input_.motors;
    if (!use(input_.synchronised ? 0 : ModelSet::kShafts)) find_fault(ErrorCode::motor_limit);
  } else if (!input_.synchronised && model_index_ != ModelSet::kShafts) {
    find_fault(ErrorCode::drive_fault);  // the drives have lost their positions
  }
  JointVector joints = joints_;
  if (model_->motors_to_joints(input_.motors, joints) != ErrorCode::none) {
    joints = joints_;
    find_fault(ErrorCode::motor_limit);
  }
  if (ticked_) {
    measured_increment_ = input_.motors - measured_motors_;
    velocity_ = (joints - joints_) / (period_ * static_cast<double>(elapsed_));
  }
  measured_motors_ = input_.motors;
  joints_ = joints;
  ++counters_.ticks;
  counters_.missed += elapsed_ - 1;
}

/// A fault that the readings show, as if the drives had reported it; theirs come first.
void Servo::find_fault(ErrorCode code) noexcept {
  if (input_.fault == ErrorCode::none) input_.fault = code;
}

void Servo::switch_off() noexcept {
  if (enabled_ && !stopping_) stop_and_switch_off();
}

void Servo::obey_order() noexcept {
  while (const Signals* outputs = hand_over_.outputs.front()) {
    put_out(*outputs);
    hand_over_.outputs.pop();
  }
  DriveOrder order = hand_over_.order.load(std::memory_order_acquire);
  if (order == DriveOrder::none) return;
  if (order == DriveOrder::disable) {
    switch_off();
  } else {
    if (stopping_) return;  // first comes the end of the stop; the order waits
    if (order == DriveOrder::recover && !enabled_ && !reset_) {
      hardware_.reset_fault();
      reset_ = true;
      return;  // the next reading tells whether the fault has gone
    }
    if (!enabled_ && (order == DriveOrder::enable || input_.fault == ErrorCode::none)) switch_on();
    reset_ = false;
  }
  ++orders_;
  // a newer order stays for the next tick
  hand_over_.order.compare_exchange_strong(order, DriveOrder::none, std::memory_order_acq_rel);
}

void Servo::switch_on() noexcept {
  fault_ = {};
  ++epoch_;
  braking_ = false;
  desired_ = DesiredState::resting_at(joints_);
  desired_motors_ = measured_motors_;
  boundary_ = last_;
  widen_limits();
  for (Regulator& regulator : regulators_) regulator.reset();
  measured_increment_.setZero();
  enabled_ = true;
  hardware_.enable(true);
}

void Servo::watch(Tick tick) noexcept {
  if (input_.fault != ErrorCode::none) latch(input_.fault, -1, 0, 0, tick);
  if (enabled_ && !stopping_) {
    for (int i = 0; i < model_->joint_count(); ++i) {
      const double error = std::abs(desired_motors_[i] - measured_motors_[i]);
      const double limit = model_->parameters().axes[static_cast<std::size_t>(i)].following_error_max;
      counters_.following_error[i] = std::max(counters_.following_error[i], error);
      if (!(error <= limit)) latch(ErrorCode::following_error, i, error, limit, tick);
    }
    if (fault_.code != ErrorCode::none) stop_and_switch_off();
  }
  if (force_.present()) watch_force(tick);
}

void Servo::watch_force(Tick tick) noexcept {
  const bool synchronised = model_index_ != ModelSet::kShafts;
  const Pose flange = synchronised ? model_->flange(joints_) : Pose::Identity();
  force_.read(tick, synchronised ? &flange : nullptr);
  ForceWatch::Doing doing = ForceWatch::Doing::resting;
  if (running_ && enabled_ && !stopping_) {
    if (active_.kind == Macrostep::Kind::path) doing = ForceWatch::Doing::moving;
    if (active_.kind == Macrostep::Kind::force) doing = ForceWatch::Doing::following;
  }
  if (const ErrorReport report = force_.look(doing); report.error_class != ErrorClass::none) interrupt(report, last_);
}

void Servo::latch(ErrorCode code, int axis, double value, double limit, Tick tick) noexcept {
  if (fault_.code == ErrorCode::none) fault_ = {code, axis, value, limit, tick};
}

bool Servo::keeps_limits(Tick tick) noexcept {
  if (model_->joints_to_motors(desired_.position, desired_motors_) != ErrorCode::none) {
    latch(ErrorCode::motor_limit, -1, 0, 0, tick);
    return stopping_;
  }
  if (stopping_) return true;  // nothing better than the stop is left
  for (int i = 0; i < model_->joint_count(); ++i) {
    const AxisParameters& axis = model_->parameters().axes[static_cast<std::size_t>(i)];
    const double position = desired_.position[i];
    const double velocity = (position - previous_position_[i]) / (period_ * static_cast<double>(elapsed_));
    if (!(position >= position_min_[i])) latch(ErrorCode::joint_limit, i, position, axis.position_min, tick);
    if (!(position <= position_max_[i])) latch(ErrorCode::joint_limit, i, position, axis.position_max, tick);
    if (!(std::abs(velocity) <= axis.velocity_max * (1 + kRounding) + kRounding))
      latch(ErrorCode::velocity_limit, i, velocity, axis.velocity_max, tick);
  }
  return fault_.code == ErrorCode::none;
}

void Servo::regulate() noexcept {
  for (int i = 0; i < model_->joint_count(); ++i)
    current_[i] =
        regulators_[static_cast<std::size_t>(i)].step(desired_motors_[i] - previous_motors_[i], measured_increment_[i]);
}

bool Servo::publish(Tick tick) noexcept {
  const bool obeyed = snapshot_.orders != orders_;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < pending_count_; ++i) {
    if (pending_[i].due <= tick && outbox_count_ < outbox_.size())
      outbox_[outbox_count_++] = {Report::Outcome::reply, pending_[i].ticket, pending_[i].start};
    else
      pending_[kept++] = pending_[i];
  }
  pending_count_ = kept;

  snapshot_.tick = tick;
  snapshot_.joints = joints_;
  snapshot_.velocity = velocity_;
  snapshot_.motors = measured_motors_;
  snapshot_.current = input_.current;
  snapshot_.synchronised = input_.synchronised;
  snapshot_.enabled = enabled_ && !stopping_;
  snapshot_.fault = fault_;
  snapshot_.model = model_index_;
  snapshot_.inputs = input_.inputs;
  snapshot_.outputs = outputs_;
  snapshot_.regulators = regulator_set_;
  snapshot_.wrench = force_.wrench();
  snapshot_.interruptions = interruptions_;
  snapshot_.interruption = interruption_;
  snapshot_.orders = orders_;
  snapshot_.epoch = epoch_;
  snapshot_.braking = braking_;
  snapshot_.desired = desired_;
  const bool end_known = running_ && active_.kind != Macrostep::Kind::force;
  snapshot_.end = end_known ? active_.to : desired_;
  snapshot_.end_tick = end_known ? active_.start + active_.steps : std::max(tick, boundary_);
  snapshot_.finished = finished_;
  snapshot_.counters = counters_;
  hand_over_.snapshot.store(snapshot_);

  const bool news = outbox_count_ > 0 || obeyed;
  for (std::size_t i = 0; i < outbox_count_; ++i) {
    Report* const report = hand_over_.reports.free_place();
    if (report == nullptr) break;
    report->outcome = outbox_[i].outcome;
    report->ticket = outbox_[i].ticket;
    report->start = outbox_[i].start;
    report->snapshot = snapshot_;
    hand_over_.reports.push_free_place();
  }
  outbox_count_ = 0;
  last_ = tick;
  ticked_ = true;
  return news;
}

}  // namespace mrroc::edp
