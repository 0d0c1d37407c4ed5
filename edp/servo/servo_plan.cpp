// The set-points of the servo: macrosteps one after the other, and the ways to leave them.
#include <algorithm>

#include "edp/servo/servo.hpp"

namespace mrroc::edp {

void Servo::advance(Tick tick) noexcept {
  refuse_foreign();
  for (;;) {
    if (running_ && active_.kind == Macrostep::Kind::force) {
      const Tick end = active_.start + active_.steps;
      follow_force(std::min(now_, static_cast<double>(end)));
      if (active_.kind == Macrostep::Kind::force && tick < end) return;
    }
    if (running_) {
      const Tick step = tick - active_.start;
      if (active_.kind == Macrostep::Kind::synchronise) {
        if (!synchronise(tick)) return;
      } else if (step < active_.steps) {
        const double time = (now_ - origin_) * period_;
        if (active_.kind == Macrostep::Kind::stop)
          desired_ = in_step_ ? common_stop_.at(time) : stop_.at(time);
        else if (active_.kind == Macrostep::Kind::path && time > 0)
          follow(time, tick);
        return;
      }
      if (active_.kind == Macrostep::Kind::model)
        change_model();
      else if (active_.kind == Macrostep::Kind::regulators)
        use_regulators();
      else if (active_.kind == Macrostep::Kind::bias)
        force_.bias();
      else if (active_.kind == Macrostep::Kind::carry)
        force_.carry(active_.load);
      else if (active_.kind != Macrostep::Kind::synchronise && active_.kind != Macrostep::Kind::force)
        desired_ = active_.to;
      running_ = false;
      boundary_ = active_.start + active_.steps;
      if (active_.ticket != 0) finished_ = active_.ticket;
      if (static_cast<double>(boundary_) >= now_) return;
    }
    if (start_next(tick)) continue;
    if (desired_.at_rest()) return;
    if (active_.kind != Macrostep::Kind::stop) {  // else a hold that ended before its stop: it continues
      ++counters_.stops;
      give_up_group(tick);
    }
    const CommonStop common = active_.kind == Macrostep::Kind::path ? active_.stop : CommonStop{};
    brake(static_cast<double>(boundary_));
    if (common.ticks > 0) brake_in_step(common);
    braking_ = true;
    refuse_foreign();
  }
}

void Servo::follow(double time, Tick tick) noexcept {
  DesiredState next;
  const ErrorCode code = active_.path.at(time, desired_.position, next);
  if (code == ErrorCode::none)
    desired_ = next;
  else  // the planner has checked this path: only a missed tick can bring it to another branch
    latch({code}, tick);
}

/// The set-point of the force macrostep at `now`, ticks, at its end at most.
void Servo::follow_force(double now) noexcept {
  if (now <= force_time_) return;
  const ErrorReport report =
      force_motion_.step(active_.force, force_.wrench(), force_.mount(), period_ * (now - force_time_), desired_);
  if (report.error_class != ErrorClass::none) return interrupt(report, force_time_, static_cast<Tick>(now_));
  force_time_ = now;
}

/// One tick of the synchronisation; true: it is over.
bool Servo::synchronise(Tick tick) noexcept {
  const bool homes = hardware_.homes();
  const Synchroniser::Status status =
      homes ? homing_.step(hardware_, input_, desired_) : synchroniser_.step(input_, desired_);
  if (status == Synchroniser::Status::running) return false;
  if (status == Synchroniser::Status::failed) {
    latch({ErrorCode::synchronisation_failed, synchronised_axis()}, tick);
    return false;  // the fault stops the robot
  }
  const JointVector& shift = homes ? homing_.shift() : synchroniser_.shift();
  hardware_.set_origin(shift);
  input_.synchronised = true;
  encoders_.shift(shift);
  measured_motors_ += shift;
  desired_motors_ += shift;
  previous_motors_ += shift;
  if (!use(0)) latch({ErrorCode::motor_limit}, tick);
  active_.steps = static_cast<std::uint32_t>(tick - active_.start);
  for (std::size_t i = 0; i < pending_count_; ++i)
    if (pending_[i].ticket == active_.ticket) pending_[i].due = tick;
  return true;
}

int Servo::synchronised_axis() const noexcept {
  if (!running_ || active_.kind != Macrostep::Kind::synchronise) return -1;
  return hardware_.homes() ? homing_.axis() : synchroniser_.axis();
}

int Servo::homing_axis() const noexcept { return hardware_.homes() ? synchronised_axis() : -1; }

void Servo::change_model() noexcept {
  if (!use(active_.choice)) latch({ErrorCode::motor_limit}, last_);
}

void Servo::use_regulators() noexcept {
  regulator_set_ = active_.choice;
  const std::vector<AxisParameters>& axes = models_.parameters().regulators[regulator_set_].axes;
  for (std::size_t i = 0; i < axes.size(); ++i) regulators_[i].use(axes[i]);
}

void Servo::put_out(const ControllerIo& outputs) noexcept {
  outputs_ = outputs;
  hardware_.set_outputs(outputs);
}

bool Servo::start_next(Tick tick) noexcept {
  const Macrostep* next = channel_.macrosteps.front();
  if (next == nullptr || next->epoch != epoch_ || state_ == ServoState::stopping || next->start > tick) return false;
  if (next->kind == Macrostep::Kind::unplanned) {
    brake(static_cast<double>(boundary_));
    braking_ = false;
    refuse_foreign();
    return true;
  }
  active_ = *next;
  channel_.macrosteps.pop();
  running_ = true;
  // a moving predecessor ended at `start`, even in a missed tick; a resting robot begins now
  active_.start = std::max({active_.start, boundary_, last_});
  origin_ = static_cast<double>(active_.start);
  if (active_.kind == Macrostep::Kind::stop) {
    stop_.plan(desired_);
    in_step_ = false;
  }
  if (active_.kind == Macrostep::Kind::force) {
    if (!forced_) force_motion_.start(desired_, active_.force.tool);
    force_time_ = origin_;
  }
  forced_ = active_.kind == Macrostep::Kind::force;
  if (active_.with_outputs) put_out(active_.outputs);
  if (active_.kind == Macrostep::Kind::synchronise) {
    synchroniser_.start(desired_.position);
    if (hardware_.homes()) homing_.start(hardware_, desired_.position);
  }
  if (active_.ticket != 0 && pending_count_ < pending_.size())
    pending_[pending_count_++] = {
        active_.ticket,
        active_.kind == Macrostep::Kind::synchronise ? kNever : active_.start + active_.reply_step,
        active_.start,
    };
  return true;
}

void Servo::refuse_foreign() noexcept {
  while (const Macrostep* next = channel_.macrosteps.front()) {
    if (state_ == ServoState::on && next->epoch == epoch_) return;
    if (next->ticket != 0 && outbox_count_ < outbox_.size())
      outbox_[outbox_count_++] = {Report::Kind::refused, next->ticket};
    channel_.macrosteps.pop();
  }
}

/// From the set-point, which is that of the time `from`, ticks.
void Servo::brake(double from) noexcept {
  ++epoch_;
  forced_ = joined_ = false;
  stop_.plan(desired_);
  active_.kind = Macrostep::Kind::stop;
  active_.ticket = 0;
  active_.start = static_cast<Tick>(from);
  origin_ = from;
  active_.steps = stop_.ticks();
  active_.from = desired_;
  active_.to = stop_.end();
  in_step_ = false;
  running_ = true;
}

void Servo::stop(ErrorCode reason, Tick tick) noexcept {
  if (stop_category(reason) == StopCategory::drives_off) return drives_off(tick);
  if (state_ == ServoState::stopping && !(in_step_ && (urgent_ || is_urgent(reason)))) return;
  if (is_hindered(reason)) stand_where_it_is();
  stop_and_switch_off(tick, reason);
}

/// The set-point is the measured state from now on. The regulators see no step: they keep what they have given.
void Servo::stand_where_it_is() noexcept {
  desired_ = DesiredState::resting_at(joints_);
  for (int i = 0; i < model_->joint_count(); ++i) {
    const double most = model_->parameters().axes[static_cast<std::size_t>(i)].velocity_max;
    desired_.velocity[i] = std::clamp(velocity_[i], -most, most);
  }
  desired_motors_ = measured_motors_;
  then_ = now_;
}

void Servo::stop_and_switch_off(Tick tick, ErrorCode reason) noexcept {
  if (homing_axis() >= 0) return drives_off(tick);  // a drive that homes does not follow our stop
  if (running_ && active_.ticket != 0) finished_ = active_.ticket;
  abort_pending();
  give_up_group(tick);
  urgent_ || is_urgent(reason) ? brake(then_) : brake_with_group();
  braking_ = false;
  state_ = ServoState::stopping;
}

/// At once, in every state of the robot.
void Servo::drives_off(Tick tick) noexcept {
  if (running_ && active_.ticket != 0) finished_ = active_.ticket;
  abort_pending();
  give_up_group(tick);
  ++epoch_;
  running_ = braking_ = joined_ = forced_ = false;
  hardware_.enable(false);
  state_ = ServoState::off;
  current_.setZero();
}

/// The motion is given up: the robot brakes from the desired state, which is that of the time `from`.
void Servo::interrupt(const ErrorReport& report, double from, Tick tick) noexcept {
  count_interruption(report);
  give_up_group(tick);
  if (active_.ticket != 0) finished_ = active_.ticket;
  brake(from);
  braking_ = false;
}

void Servo::count_interruption(const ErrorReport& report) noexcept {
  ++interruptions_;
  interruption_ = report;
  abort_pending();
}

void Servo::abort_pending() noexcept {
  for (std::size_t i = 0; i < pending_count_ && outbox_count_ < outbox_.size(); ++i)
    outbox_[outbox_count_++] = {Report::Kind::aborted, pending_[i].ticket};
  pending_count_ = 0;
}

}  // namespace mrroc::edp
