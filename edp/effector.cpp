#include "edp/effector.hpp"

#include <algorithm>

#include "edp/error_report.hpp"

namespace mrroc::edp {

Effector::Effector(const RobotModel& model, double period, HandOver& hand_over)
    : model_(model), kinematics_(model), hand_over_(hand_over), planner_(model, period) {}

void Effector::enable(bool on) noexcept {
  hand_over_.order.store(on ? DriveOrder::enable : DriveOrder::disable, std::memory_order_release);
}

void Effector::refresh() noexcept {
  const bool first = snapshot_ == nullptr;
  snapshot_ = hand_over_.snapshot.load();
  if (snapshot_ == nullptr) return;
  if (first || snapshot_->epoch != epoch_) {
    epoch_ = snapshot_->epoch;
    end_ = snapshot_->end;
    end_tick_ = snapshot_->end_tick;
    untold_ = snapshot_->braking;
  }
  for (Outstanding& entry : outstanding_)
    if (entry.used && entry.replied && entry.ticket <= snapshot_->finished) entry.used = false;
}

bool Effector::accept(const RobotCommand& command, std::uint64_t number, Reply& reply) noexcept {
  refresh();
  ErrorReport error;
  if (snapshot_ == nullptr) {
    error = make_report(ErrorClass::non_fatal, ErrorCode::busy, "the servo has not ticked yet");
  } else if (command.kind != CommandKind::query) {
    error = refusal(command);
    Outstanding* entry = free_place();
    if (error.error_class == ErrorClass::none) {
      if (entry == nullptr) {
        error = make_report(ErrorClass::non_fatal, ErrorCode::busy, "one command runs and one waits already");
      } else {
        entry->used = true;
        entry->replied = entry->late = false;
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
  if (snapshot_->fault.code != ErrorCode::none) return make_report(snapshot_->fault, model_.parameters());
  if (!snapshot_->enabled)
    return make_report(ErrorClass::non_fatal, ErrorCode::not_enabled, "at tick %llu",
                       static_cast<unsigned long long>(snapshot_->tick));
  if (!snapshot_->synchronised && command.kind != CommandKind::hold)
    return make_report(ErrorClass::non_fatal, ErrorCode::not_synchronised, "it may only hold");
  if (command.start_tick > snapshot_->tick + kMaxMotionSteps)
    return make_report(ErrorClass::non_fatal, ErrorCode::invalid_argument, "start_tick %llu, expected at most %llu",
                       static_cast<unsigned long long>(command.start_tick),
                       static_cast<unsigned long long>(snapshot_->tick + kMaxMotionSteps));
  return {};
}

Effector::Outstanding* Effector::free_place() noexcept {
  for (Outstanding& entry : outstanding_)
    if (!entry.used) return &entry;
  return nullptr;
}

ErrorReport Effector::hand_over(Outstanding& entry) noexcept {
  const RobotCommand& command = entry.command;
  const bool moves = command.kind == CommandKind::joint || command.kind == CommandKind::pose;
  if (untold_ && moves && !entry.late) {
    entry.late = true;
    ++counters_.late;
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
  const Pace pace = entry.late ? Pace::stretched : Pace::as_commanded;
  const ErrorReport error = planner_.plan(command, from, pace, macrostep_);
  if (error.error_class != ErrorClass::none) return error;
  if (moves && macrostep_.steps > command.motion_steps) ++counters_.stretched;
  macrostep_.ticket = entry.ticket;
  macrostep_.epoch = epoch_;
  macrostep_.start = std::max(at, command.start_tick);
  if (stop_first) hand_over_.macrosteps.push(stop_);
  hand_over_.macrosteps.push(macrostep_);
  end_ = macrostep_.to;
  end_tick_ = macrostep_.start + macrostep_.steps;
  return {};
}

bool Effector::poll(Reply& reply) noexcept {
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
      fill(then, then.end, then.end_tick, reply.state);
      if (outcome == Report::Outcome::aborted && then.fault.code == ErrorCode::none)
        reply.state.error = make_report(ErrorClass::non_fatal, ErrorCode::not_enabled, "the drives were switched off");
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
  state.pose = kinematics_.direct(snapshot.joints);
  state.desired_tick = end_tick;
  state.desired_joints = end.position;
  state.desired_velocity = end.velocity;
  state.desired_acceleration = end.acceleration;
  state.desired_pose = kinematics_.direct(end.position);
  state.model = 0;
  state.tool = kinematics_.tool();
  state.synchronised = snapshot.synchronised;
  state.enabled = snapshot.enabled;
  state.late_commands = counters_.late;
  state.error =
      snapshot.fault.code == ErrorCode::none ? ErrorReport{} : make_report(snapshot.fault, model_.parameters());
}

}  // namespace mrroc::edp
