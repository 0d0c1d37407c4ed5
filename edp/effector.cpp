#include "edp/effector.hpp"

#include <algorithm>
#include <cmath>

#include "edp/error_report.hpp"
#include "edp/force_law.hpp"

namespace mrroc::edp {

namespace {

/// Of the robot itself; unknown kinds are refused as such.
bool is_change(CommandKind kind) noexcept { return kind >= CommandKind::set_tool; }

bool is_motion(CommandKind kind) noexcept {
  return kind != CommandKind::query && kind != CommandKind::hold && !is_change(kind);
}

Macrostep::Kind kind_of(CommandKind change) noexcept {
  switch (change) {
    case CommandKind::use_model:
      return Macrostep::Kind::model;
    case CommandKind::use_regulators:
      return Macrostep::Kind::regulators;
    case CommandKind::bias_force:
      return Macrostep::Kind::bias;
    default:
      return Macrostep::Kind::synchronise;
  }
}

}  // namespace

Effector::Effector(const ModelSet& models, double period, HandOver& hand_over)
    : models_(models), hand_over_(hand_over), planner_(models.at(0), period), tool_(models.at(0).default_tool()) {}

void Effector::enable(bool on) noexcept {
  hand_over_.order.store(on ? DriveOrder::enable : DriveOrder::disable, std::memory_order_release);
}

void Effector::refresh() noexcept {
  const bool first = snapshot_ == nullptr;
  snapshot_ = hand_over_.snapshot.load();
  if (snapshot_ == nullptr) return;
  if (snapshot_->model != model_) use_model();
  if (first || snapshot_->epoch != epoch_) {
    epoch_ = snapshot_->epoch;
    end_ = snapshot_->end;
    end_tick_ = snapshot_->end_tick;
    untold_ = snapshot_->braking;
    forced_ = false;
  }
  for (Outstanding& entry : outstanding_)
    if (entry.used && entry.replied && entry.ticket <= snapshot_->finished) entry.used = false;
}

/// The servo has changed to another model.
void Effector::use_model() noexcept {
  model_ = snapshot_->model;
  planner_.use(ToolKinematics(models_.at(model_), tool_));
}

bool Effector::accept(const RobotCommand& command, std::uint64_t number, Reply& reply) noexcept {
  refresh();
  ErrorReport error;
  if (snapshot_ == nullptr) {
    error = make_report(ErrorClass::non_fatal, ErrorCode::busy, "the servo has not ticked yet");
  } else if (command.kind == CommandKind::recover) {
    recovery_ = {true, number, snapshot_->orders};
    hand_over_.order.store(DriveOrder::recover, std::memory_order_release);
    return false;
  } else if (command.kind != CommandKind::query) {
    error = command.kind == CommandKind::set_outputs ? refusal_of_outputs(command.outputs) : refusal(command);
    if (error.error_class == ErrorClass::none && command.kind == CommandKind::set_tool) {
      tool_ = command.pose;
      planner_.use(ToolKinematics(models_.at(model_), tool_));
      answer(number, {}, reply);
      return true;
    }
    if (error.error_class == ErrorClass::none && command.kind == CommandKind::set_outputs) {
      if (!hand_over_.outputs.push(command.outputs))
        error = make_report(ErrorClass::non_fatal, ErrorCode::busy, "outputs that the servo has not taken yet");
      answer(number, error, reply);
      return true;
    }
    Outstanding* entry = free_place();
    if (error.error_class == ErrorClass::none) {
      if (entry == nullptr) {
        error = make_report(ErrorClass::non_fatal, ErrorCode::busy, "one command runs and one waits already");
      } else {
        entry->used = true;
        entry->replied = entry->late = entry->after_force = false;
        entry->ticket = ++last_ticket_;
        entry->number = number;
        entry->command = command;
        error = hand_over(*entry);
        if (error.error_class == ErrorClass::none) {
          ++counters_.accepted;
          return false;
        }
        entry->used = false;
      }
    }
  }
  answer(number, error, reply);
  return true;
}

ErrorReport Effector::refusal(const RobotCommand& command) const noexcept {
  if (snapshot_->fault.code != ErrorCode::none) return make_report(snapshot_->fault, models_.parameters());
  if (!snapshot_->enabled)
    return make_report(ErrorClass::non_fatal, ErrorCode::not_enabled, "at tick %llu",
                       static_cast<unsigned long long>(snapshot_->tick));
  if (snapshot_->interruptions != interruptions_told_) return snapshot_->interruption;
  if (is_change(command.kind)) return refusal_of_change(command);
  if (command.with_outputs)
    if (const ErrorReport report = refusal_of_outputs(command.outputs); report.error_class != ErrorClass::none)
      return report;
  if (command.kind == CommandKind::force && !mount_)
    return make_report(ErrorClass::non_fatal, ErrorCode::invalid_argument,
                       "a force motion of a robot without force_sensor in the deployment");
  if (!snapshot_->synchronised && command.kind != CommandKind::hold &&
      !(command.kind == CommandKind::motor && command.relative && command.interpolation != Interpolation::task))
    return make_report(ErrorClass::non_fatal, ErrorCode::not_synchronised,
                       "only relative motor motion, hold and synchronise");
  if (command.start_tick > snapshot_->tick + kMaxMotionSteps)
    return make_report(ErrorClass::non_fatal, ErrorCode::invalid_argument, "start_tick %llu, expected at most %llu",
                       static_cast<unsigned long long>(command.start_tick),
                       static_cast<unsigned long long>(snapshot_->tick + kMaxMotionSteps));
  return {};
}

ErrorReport Effector::refusal_of_outputs(const Signals& outputs) const noexcept {
  for (std::size_t i = 0; i < outputs.analog.size(); ++i)
    if (!std::isfinite(outputs.analog[i]))
      return make_report(ErrorClass::non_fatal, ErrorCode::not_finite, "analogue output %d is %g", static_cast<int>(i),
                         outputs.analog[i]);
  return {};
}

ErrorReport Effector::refusal_of_change(const RobotCommand& command) const noexcept {
  if (forced_ || !end_.at_rest()) return make_report(ErrorClass::non_fatal, ErrorCode::busy, "only at rest");
  switch (command.kind) {
    case CommandKind::set_tool:
      if (!is_rigid(command.pose))
        return make_report(ErrorClass::non_fatal, ErrorCode::invalid_argument, "the tool is not a rigid frame");
      return {};
    case CommandKind::use_model:
      if (!snapshot_->synchronised)
        return make_report(ErrorClass::non_fatal, ErrorCode::not_synchronised, "no model before");
      if (command.choice >= models_.size())
        return make_report(ErrorClass::non_fatal, ErrorCode::invalid_argument, "model %d, expected 0..%d",
                           int{command.choice}, static_cast<int>(models_.size()) - 1);
      return {};
    case CommandKind::synchronise:
      if (snapshot_->synchronised)
        return make_report(ErrorClass::non_fatal, ErrorCode::invalid_argument, "already synchronised");
      for (const AxisParameters& axis : models_.parameters().axes)
        if (axis.synchro_coarse == 0)
          return make_report(ErrorClass::non_fatal, ErrorCode::invalid_argument,
                             "axis %s has no synchronisation switch", axis.name.c_str());
      return {};
    case CommandKind::use_regulators: {
      const std::size_t count = models_.parameters().regulators.size();
      if (command.choice >= count)
        return make_report(ErrorClass::non_fatal, ErrorCode::invalid_argument, "regulator set %d, expected below %d",
                           int{command.choice}, static_cast<int>(count));
      return {};
    }
    case CommandKind::bias_force:
      if (!mount_)
        return make_report(ErrorClass::non_fatal, ErrorCode::invalid_argument,
                           "the robot has no force_sensor in the deployment");
      return {};
    default:
      return make_report(ErrorClass::non_fatal, ErrorCode::invalid_argument, "kind %d is unknown",
                         static_cast<int>(command.kind));
  }
}

Effector::Outstanding* Effector::free_place() noexcept {
  for (Outstanding& entry : outstanding_)
    if (!entry.used) return &entry;
  return nullptr;
}

ErrorReport Effector::hand_over(Outstanding& entry) noexcept {
  const RobotCommand& command = entry.command;
  const bool moves = is_motion(command.kind);
  if (untold_ && moves && !entry.late) {
    entry.late = true;
    ++counters_.late;
  }

  if (forced_ && (command.kind != CommandKind::force || command.start_tick > end_tick_)) {
    entry.after_force = true;
    macrostep_.kind = Macrostep::Kind::unplanned;
    macrostep_.ticket = entry.ticket;
    macrostep_.epoch = epoch_;
    macrostep_.start = 0;
    hand_over_.macrosteps.push(macrostep_);
    return {};
  }

  DesiredState from = end_;
  Tick at = from.at_rest() ? std::max(end_tick_, snapshot_->tick) : end_tick_;
  const bool stop_first = !from.at_rest() && command.start_tick > at;
  if (stop_first) {
    planner_.plan_stop(from, 1, stop_);
    stop_.ticket = 0;
    stop_.epoch = epoch_;
    stop_.start = at;
    from = stop_.to;
    at += stop_.steps;
  }
  if (is_change(command.kind)) {
    macrostep_.kind = kind_of(command.kind);
    macrostep_.choice = command.choice;
    macrostep_.steps = macrostep_.reply_step = 1;
    macrostep_.from = macrostep_.to = from;
  } else {
    const Pace pace = entry.late || entry.after_force ? Pace::stretched : Pace::as_commanded;
    const ErrorReport error = planner_.plan(command, from, pace, macrostep_);
    if (error.error_class != ErrorClass::none) return error;
  }
  if (moves && macrostep_.steps > command.motion_steps) ++counters_.stretched;
  macrostep_.ticket = entry.ticket;
  macrostep_.epoch = epoch_;
  macrostep_.with_outputs = moves && command.with_outputs;
  macrostep_.outputs = command.outputs;
  macrostep_.start = std::max(at, command.start_tick);
  if (stop_first) hand_over_.macrosteps.push(stop_);
  hand_over_.macrosteps.push(macrostep_);
  end_ = macrostep_.to;
  end_tick_ = macrostep_.start + macrostep_.steps;
  forced_ = macrostep_.kind == Macrostep::Kind::force;
  return {};
}

bool Effector::poll_recovery(Reply& reply) noexcept {
  refresh();
  if (!recovery_.under_way || snapshot_ == nullptr || snapshot_->orders == recovery_.orders) return false;
  recovery_.under_way = false;
  answer(recovery_.number, {}, reply);  // a fault that came back is in it
  return true;
}

bool Effector::poll(Reply& reply) noexcept {
  if (recovery_.under_way && poll_recovery(reply)) return true;
  while (const Report* report = hand_over_.reports.front()) {
    refresh();  // after the report was seen, so that the snapshot is at least as new
    Outstanding* entry = nullptr;
    for (Outstanding& candidate : outstanding_)
      if (candidate.used && candidate.ticket == report->ticket) entry = &candidate;
    const Report::Outcome outcome = report->outcome;
    bool answered = entry != nullptr;
    if (entry != nullptr && outcome == Report::Outcome::refused) {
      ErrorReport error = refusal(entry->command);
      if (error.error_class == ErrorClass::none) error = hand_over(*entry);
      answered = error.error_class != ErrorClass::none;
      if (answered) {
        entry->used = false;
        answer(entry->number, error, reply);
      }
    } else if (entry != nullptr) {
      const Snapshot& then = report->snapshot;
      reply.command = entry->number;
      if (outcome == Report::Outcome::reply) macrostep_start_ = report->start;
      fill(then, then.end, then.end_tick, reply.state);
      if (outcome == Report::Outcome::aborted && then.fault.code == ErrorCode::none) {
        const bool interrupted = then.interruptions != interruptions_told_;
        reply.state.error =
            interrupted ? then.interruption
                        : make_report(ErrorClass::non_fatal, ErrorCode::not_enabled, "the drives were switched off");
        interruptions_told_ = then.interruptions;
      }
      if (then.epoch == epoch_) untold_ = false;
      entry->replied = true;
    }
    hand_over_.reports.pop();
    if (answered) return true;
  }
  return false;
}

void Effector::answer(std::uint64_t number, const ErrorReport& error, Reply& reply) noexcept {
  reply.command = number;
  reply.state = RobotState{};
  fill_present(reply.state);
  if (error.error_class != ErrorClass::none) {
    reply.state.error = error;
    ++counters_.refused;
    if (snapshot_ != nullptr) interruptions_told_ = snapshot_->interruptions;
  }
  untold_ = false;
}

bool Effector::peek(RobotState& state) noexcept {
  refresh();
  fill_present(state);
  return snapshot_ != nullptr;
}

void Effector::fill_present(RobotState& state) const noexcept {
  if (snapshot_ == nullptr) return;
  if (snapshot_->enabled)
    fill(*snapshot_, end_, std::max(end_tick_, snapshot_->tick), state);
  else
    fill(*snapshot_, snapshot_->end, snapshot_->end_tick, state);
}

void Effector::fill(const Snapshot& snapshot, const DesiredState& end, Tick end_tick,
                    RobotState& state) const noexcept {
  state.tick = snapshot.tick;
  state.joints = snapshot.joints;
  state.joint_velocity = snapshot.velocity;
  state.motors = snapshot.motors;
  state.current = snapshot.current;
  state.pose = planner_.kinematics().direct(snapshot.joints);
  state.macrostep_start = macrostep_start_;
  state.desired_tick = end_tick;
  state.desired_joints = end.position;
  state.desired_velocity = end.velocity;
  state.desired_acceleration = end.acceleration;
  state.desired_pose = planner_.kinematics().direct(end.position);
  state.model = model_;
  state.tool = tool_;
  state.wrench = mount_ ? seen_from(mount_->inverse() * tool_, snapshot.wrench) : Wrench::Zero();
  state.inputs = snapshot.inputs;
  state.outputs = snapshot.outputs;
  state.regulators = snapshot.regulators;
  state.synchronised = snapshot.synchronised;
  state.enabled = snapshot.enabled;
  state.late_commands = counters_.late;
  state.error =
      snapshot.fault.code == ErrorCode::none ? ErrorReport{} : make_report(snapshot.fault, models_.parameters());
}

}  // namespace mrroc::edp
