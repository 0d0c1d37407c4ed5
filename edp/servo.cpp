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
    if (!use(input_.synchronised ? 0 : ModelSet::kShafts)) latch(ErrorCode::motor_limit, -1, 0, 0, tick);
  } else if (!input_.synchronised && model_index_ != ModelSet::kShafts) {
    latch(ErrorCode::drive_fault, -1, 0, 0, tick);  // the drives have lost their positions
  }
  JointVector joints = joints_;
  if (model_->motors_to_joints(input_.motors, joints) != ErrorCode::none) {
    joints = joints_;
    latch(ErrorCode::motor_limit, -1, 0, 0, tick);
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

/// The motion is given up: the robot brakes from the desired state, which is that of tick `from`.
void Servo::interrupt(const ErrorReport& report, Tick from) noexcept {
  ++interruptions_;
  interruption_ = report;
  if (active_.ticket != 0) finished_ = active_.ticket;
  abort_pending();
  brake(from);
  braking_ = false;
}

void Servo::abort_pending() noexcept {
  for (std::size_t i = 0; i < pending_count_ && outbox_count_ < outbox_.size(); ++i)
    outbox_[outbox_count_++] = {Report::Outcome::aborted, pending_[i].ticket};
  pending_count_ = 0;
}

void Servo::latch(ErrorCode code, int axis, double value, double limit, Tick tick) noexcept {
  if (fault_.code == ErrorCode::none) fault_ = {code, axis, value, limit, tick};
}

void Servo::advance(Tick tick) noexcept {
  refuse_foreign();
  for (;;) {
    if (running_ && active_.kind == Macrostep::Kind::force) {
      const Tick end = active_.start + active_.steps;
      follow_force(std::min(tick, end));
      if (active_.kind == Macrostep::Kind::force && tick < end) return;
    }
    if (running_) {
      const Tick step = tick - active_.start;
      if (active_.kind == Macrostep::Kind::synchronise) {
        if (!synchronise(tick)) return;
      } else if (step < active_.steps) {
        const double time = static_cast<double>(step) * period_;
        if (active_.kind == Macrostep::Kind::stop)
          desired_ = stop_.at(time);
        else if (active_.kind == Macrostep::Kind::path && step > 0)
          follow(time, tick);
        return;
      }
      if (active_.kind == Macrostep::Kind::model)
        change_model();
      else if (active_.kind == Macrostep::Kind::regulators)
        use_regulators();
      else if (active_.kind == Macrostep::Kind::bias)
        force_.bias();
      else if (active_.kind != Macrostep::Kind::synchronise && active_.kind != Macrostep::Kind::force)
        desired_ = active_.to;
      running_ = false;
      boundary_ = active_.start + active_.steps;
      if (active_.ticket != 0) finished_ = active_.ticket;
      if (boundary_ == tick) return;
    }
    if (start_next(tick)) continue;
    if (desired_.at_rest()) return;
    ++counters_.stops;
    brake(boundary_);
    braking_ = true;
    refuse_foreign();
  }
}

void Servo::follow(double time, Tick tick) noexcept {
  DesiredState next;
  const ErrorCode code = active_.path.at(time, desired_.position, next);
  if (code == ErrorCode::none)
    desired_ = next;
  else  // the planner has been along this path: only a missed tick can bring it to another branch
    latch(code, -1, 0, 0, tick);
}

/// The set-point of tick `tick` of the force macrostep, which is not its end or a tick before it.
void Servo::follow_force(Tick tick) noexcept {
  if (tick == force_tick_) return;
  const ErrorReport report = force_motion_.step(active_.force, force_.wrench(), force_.mount(),
                                                period_ * static_cast<double>(tick - force_tick_), desired_);
  if (report.error_class != ErrorClass::none) return interrupt(report, force_tick_);
  force_tick_ = tick;
}

/// One tick of the synchronisation; true: it is over.
bool Servo::synchronise(Tick tick) noexcept {
  const Synchroniser::Status status = synchroniser_.step(input_, desired_);
  if (status == Synchroniser::Status::running) return false;
  if (status == Synchroniser::Status::failed) {
    latch(ErrorCode::synchronisation_failed, synchroniser_.axis(), 0, 0, tick);
    return false;  // the fault stops the robot
  }
  const JointVector& shift = synchroniser_.shift();
  hardware_.set_origin(shift);
  input_.synchronised = true;
  measured_motors_ += shift;
  desired_motors_ += shift;
  previous_motors_ += shift;
  if (!use(0)) latch(ErrorCode::motor_limit, -1, 0, 0, tick);
  active_.steps = static_cast<std::uint32_t>(tick - active_.start);
  for (std::size_t i = 0; i < pending_count_; ++i)
    if (pending_[i].ticket == active_.ticket) pending_[i].due = tick;
  return true;
}

void Servo::change_model() noexcept {
  if (!use(active_.choice)) latch(ErrorCode::motor_limit, -1, 0, 0, last_);
}

void Servo::use_regulators() noexcept {
  regulator_set_ = active_.choice;
  const std::vector<AxisParameters>& axes = models_.parameters().regulators[regulator_set_].axes;
  for (std::size_t i = 0; i < axes.size(); ++i) regulators_[i].use(axes[i]);
}

void Servo::put_out(const Signals& outputs) noexcept {
  outputs_ = outputs;
  hardware_.set_outputs(outputs);
}

bool Servo::start_next(Tick tick) noexcept {
  const Macrostep* next = hand_over_.macrosteps.front();
  if (next == nullptr || next->epoch != epoch_ || stopping_ || next->start > tick) return false;
  if (next->kind == Macrostep::Kind::unplanned) {
    brake(boundary_);
    braking_ = false;
    refuse_foreign();
    return true;
  }
  active_ = *next;
  hand_over_.macrosteps.pop();
  running_ = true;
  // a moving predecessor ended at `start`, be it in a missed tick; a resting robot begins now
  active_.start = std::max({active_.start, boundary_, last_});
  if (active_.kind == Macrostep::Kind::stop) stop_.plan(desired_);
  if (active_.kind == Macrostep::Kind::force) {
    if (!forced_) force_motion_.start(desired_, active_.force.tool);
    force_tick_ = active_.start;
  }
  forced_ = active_.kind == Macrostep::Kind::force;
  if (active_.with_outputs) put_out(active_.outputs);
  if (active_.kind == Macrostep::Kind::synchronise) synchroniser_.start(desired_.position);
  if (active_.ticket != 0 && pending_count_ < pending_.size())
    pending_[pending_count_++] = {
        active_.ticket,
        active_.kind == Macrostep::Kind::synchronise ? kNever : active_.start + active_.reply_step,
        active_.start,
    };
  return true;
}

void Servo::refuse_foreign() noexcept {
  while (const Macrostep* next = hand_over_.macrosteps.front()) {
    if (enabled_ && !stopping_ && next->epoch == epoch_) return;
    if (next->ticket != 0 && outbox_count_ < outbox_.size())
      outbox_[outbox_count_++] = {Report::Outcome::refused, next->ticket};
    hand_over_.macrosteps.pop();
  }
}

void Servo::brake(Tick from) noexcept {
  ++epoch_;
  forced_ = false;
  stop_.plan(desired_);
  active_.kind = Macrostep::Kind::stop;
  active_.ticket = 0;
  active_.start = from;
  active_.steps = stop_.ticks();
  active_.from = desired_;
  active_.to = stop_.end();
  running_ = true;
}

void Servo::stop_and_switch_off() noexcept {
  if (running_ && active_.ticket != 0) finished_ = active_.ticket;
  abort_pending();
  brake(last_);
  braking_ = false;
  stopping_ = true;
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
