#include "edp/servo/servo.hpp"

#include <algorithm>
#include <cmath>

namespace mrroc::edp {

Servo::Servo(const ModelSet& models, Hardware& hardware, double period, ServoChannel& hand_over)
    : models_(models),
      model_(&models.at(0)),
      hardware_(hardware),
      period_(period),
      channel_(hand_over),
      stop_(models.parameters(), period),
      group_(models.at(0), period),
      synchroniser_(models.parameters(), models.at(ModelSet::kShafts).parameters(), period),
      homing_(models.parameters()),
      encoders_(models.at(0), period),
      currents_(models.parameters(), period),
      motion_(period),
      switches_(models.parameters()),
      force_motion_(models.at(0), period) {
  const int count = model_->joint_count();
  for (const AxisParameters& axis : models.parameters().axes) regulators_.emplace_back(axis);
  const JointVector zero = JointVector::Zero(count);
  joints_ = read_joints_ = velocity_ = measured_motors_ = measured_increment_ = current_ = zero;
  desired_motors_ = previous_position_ = previous_motors_ = position_min_ = position_max_ = zero;
  input_.motors = input_.current = zero;
  desired_ = DesiredState::resting_at(zero);
  counters_.following_error = zero;
}

void Servo::use_force_sensor(ForceSensor& sensor, const ForceLimits& limits) noexcept { force_.use(sensor, limits); }

/// The robot rests: the same shafts, seen as joints of another model. False: they are not valid joints of that model.
bool Servo::use(std::uint8_t index) noexcept {
  const RobotModel& model = models_.at(index);
  JointVector joints, desired;
  if (model.motors_to_joints(measured_motors_, joints) != ErrorCode::none) return false;
  if (model.motors_to_joints(desired_motors_, desired) != ErrorCode::none) return false;
  model_ = &model;
  model_index_ = index;
  stop_.use(model.parameters());
  group_.use(model);
  force_motion_.use(model);
  joints_ = read_joints_ = joints;
  velocity_.setZero();
  desired_ = DesiredState::resting_at(desired);
  previous_position_ = desired;
  widen_limits();
  motion_.reset();
  ++epoch_;
  return true;
}

bool Servo::tick(Tick tick, double ahead, double measured) noexcept {
  now_ = static_cast<double>(tick) + ahead;
  measure(tick, measured);
  obey_order(tick);
  watch(tick);
  if (has_power(state_)) {
    previous_position_ = desired_.position;
    previous_motors_ = desired_motors_;
    const DesiredState before = desired_;
    const RobotModel* const model = model_;
    advance(tick);
    if (!keeps_limits(tick)) {
      if (model_ == model) desired_ = before;
      boundary_ = last_;
      stop_and_switch_off(tick, fault_.code);
      advance(tick);
      model_->joints_to_motors(desired_.position, desired_motors_);
    }
    if (has_power(state_)) regulate();
    if (state_ == ServoState::stopping && !running_) drives_off(tick);
  } else {
    refuse_foreign();
    desired_ = DesiredState::resting_at(joints_);
    desired_motors_ = previous_motors_ = measured_motors_;
  }
  hardware_.set_points(desired_motors_, (desired_motors_ - previous_motors_) / (period_ * elapsed_));
  hardware_.write(tick, current_);
  if (tap_ != nullptr) record(tick);
  return publish(tick);
}

void Servo::record(Tick tick) noexcept {
  ServoSample* const sample = tap_->claim(tap_waits_);
  if (sample == nullptr) return;
  sample->tick = tick;
  sample->ahead = now_ - static_cast<double>(tick);
  sample->measured = input_.time;
  sample->axes = static_cast<std::uint32_t>(joints_.size());
  const auto copy = [](const JointVector& from, ServoSample::Values& to) {
    std::copy_n(from.data(), std::min(from.size(), static_cast<Eigen::Index>(to.size())), to.begin());
  };
  copy(joints_, sample->joints);
  copy(velocity_, sample->velocity);
  copy(desired_.position, sample->desired_joints);
  copy(measured_motors_, sample->motors);
  copy(desired_motors_, sample->desired_motors);
  copy(input_.current, sample->current);
  copy(current_, sample->commanded_current);
  Eigen::Map<Wrench>(sample->wrench.data()) = force_.wrench();
  sample->inputs = input_.inputs;
  sample->outputs = outputs_;
  sample->state = state_;
  sample->fault = fault_.code;
  sample->fault_axis = static_cast<std::int8_t>(fault_.axis);
  tap_->publish();
}

void Servo::leave() noexcept {
  leaving_ = true;
  give_up_power();
  if (state_ == ServoState::on) stop_and_switch_off(last_ + 1, ErrorCode::not_enabled);
}

void Servo::obey_order(Tick tick) noexcept {
  while (const ControllerIo* outputs = channel_.outputs.front()) {
    put_out(*outputs);
    channel_.outputs.pop();
  }
  DriveOrder order = channel_.order.load(std::memory_order_acquire);
  if (order == DriveOrder::none) return;
  if (order == DriveOrder::disable) {
    give_up_power();
    if (state_ == ServoState::on) stop_and_switch_off(tick, ErrorCode::not_enabled);
  } else {
    if (state_ == ServoState::stopping || leaving_) return;  // the order waits for the end of the stop
    if (order == DriveOrder::recover && state_ != ServoState::on && !is_cleared(state_)) {
      give_up_power();
      hardware_.reset_fault();
      state_ = ServoState::cleared;
      return;  // the next reading shows whether the fault is gone
    }
    if (state_ != ServoState::on && !switch_on()) return;
  }
  ++orders_;
  // a newer order stays for the next tick
  channel_.order.compare_exchange_strong(order, DriveOrder::none, std::memory_order_acq_rel);
}

/// Drives that are switching on go off again.
void Servo::give_up_power() noexcept {
  if (is_powering(state_)) hardware_.enable(false);
  if (!has_power(state_)) state_ = ServoState::off;
}

/// False: not yet; the order waits.
bool Servo::switch_on() noexcept {
  const bool refused = found_.code != ErrorCode::none;
  if (hardware_.busy() && !(is_powering(state_) && refused)) return false;
  // the next reading is seen as joints of the other model; positions that are invalid in it count as unknown
  const bool other_model = input_.synchronised != (model_index_ != ModelSet::kShafts);
  if (hardware_.homes() && other_model && use(input_.synchronised ? 0 : ModelSet::kShafts)) return false;
  fault_ = {};
  if (refused) {  // `watch` latches it
    give_up_power();
    return true;
  }
  if (!is_powering(state_)) hardware_.enable(true);
  if (hardware_.busy()) {
    state_ = is_cleared(state_) ? ServoState::powering_cleared : ServoState::powering;
    return false;
  }
  ++epoch_;
  braking_ = joined_ = false;
  desired_ = DesiredState::resting_at(joints_);
  desired_motors_ = previous_motors_ = measured_motors_;
  boundary_ = last_;
  widen_limits();
  for (Regulator& regulator : regulators_) regulator.reset();
  currents_.reset();
  motion_.reset();
  measured_increment_.setZero();
  state_ = ServoState::on;
  return true;
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
      outbox_[outbox_count_++] = {Report::Kind::reply, pending_[i].ticket, pending_[i].start};
    else
      pending_[kept++] = pending_[i];
  }
  pending_count_ = kept;

  snapshot_.tick = tick;
  snapshot_.joints = joints_;
  snapshot_.joint_velocity = velocity_;
  snapshot_.motors = measured_motors_;
  snapshot_.current = input_.current;
  snapshot_.synchronised = input_.synchronised && model_index_ != ModelSet::kShafts;
  snapshot_.drives_home = hardware_.homes();
  snapshot_.state = state_;
  snapshot_.fault = fault_;
  snapshot_.switches = switches_.on();
  snapshot_.model = model_index_;
  snapshot_.inputs = input_.inputs;
  snapshot_.outputs = outputs_;
  snapshot_.regulators = regulator_set_;
  snapshot_.wrench = force_.wrench();
  snapshot_.lost = running_ && active_.kind == Macrostep::Kind::force ? force_motion_.lost() : 0;
  snapshot_.interruptions = interruptions_;
  snapshot_.interruption = interruption_;
  snapshot_.orders = orders_;
  snapshot_.epoch = epoch_;
  snapshot_.braking = braking_;
  snapshot_.joined = joined_;
  snapshot_.given_up = group_.given_up();
  snapshot_.desired = desired_;
  const bool end_known = running_ && active_.kind != Macrostep::Kind::force;
  snapshot_.end = end_known ? active_.to : desired_;
  snapshot_.end_tick = end_known ? active_.start + active_.steps : std::max(tick, boundary_);
  snapshot_.finished = finished_;
  snapshot_.counters = counters_;
  channel_.snapshot.store(snapshot_);

  const bool news = outbox_count_ > 0 || obeyed;
  for (std::size_t i = 0; i < outbox_count_; ++i) {
    Report* const report = channel_.reports.free_place();
    if (report == nullptr) break;
    report->kind = outbox_[i].kind;
    report->ticket = outbox_[i].ticket;
    report->start = outbox_[i].start;
    report->snapshot = snapshot_;
    channel_.reports.push_free_place();
  }
  outbox_count_ = 0;
  last_ = tick;
  then_ = now_;
  ticked_ = true;
  return news;
}

}  // namespace mrroc::edp
