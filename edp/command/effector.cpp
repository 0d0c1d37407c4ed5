#include "edp/command/effector.hpp"

#include <algorithm>
#include <cmath>

#include "edp/force/force_law.hpp"
#include "edp/safety/error_report.hpp"
#include "geometry/rigid_motion.hpp"

namespace mrroc::edp {

namespace {

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
    case CommandKind::carry:
      return Macrostep::Kind::carry;
    default:
      return Macrostep::Kind::synchronise;
  }
}

/// What is executed of a command whose motion the robot and those of its group have given up, or which is late and of
/// several robots in motion: nothing, so that they stay in step.
RobotCommand hold_instead_of(const RobotCommand& command) noexcept {
  RobotCommand hold;
  hold.kind = CommandKind::hold;
  hold.motion_steps = command.motion_steps;
  hold.reply_step = command.reply_step;
  hold.start_tick = command.start_tick;
  hold.stop.group = command.stop.group;
  return hold;
}

}  // namespace

Effector::Effector(const ModelSet& models, double period, ServoChannel& hand_over)
    : models_(models), channel_(hand_over), planner_(models.at(0), period), tool_(models.at(0).default_tool()) {}

void Effector::enable(bool on) noexcept {
  channel_.order.store(on ? DriveOrder::enable : DriveOrder::disable, std::memory_order_release);
}

void Effector::refresh() noexcept {
  const bool first = snapshot_ == nullptr;
  snapshot_ = channel_.snapshot.load();
  if (snapshot_ == nullptr) return;
  if (snapshot_->model != model_) use_model();
  planner_.stand_on(snapshot_->switches);
  if (first || snapshot_->epoch != epoch_) {
    epoch_ = snapshot_->epoch;
    end_ = snapshot_->end;
    end_tick_ = snapshot_->end_tick;
    unreported_ = snapshot_->braking;
    joined_ = snapshot_->joined;
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
    if (!recovery_.under_way) {
      recovery_ = {true, number, snapshot_->orders};
      channel_.order.store(DriveOrder::recover, std::memory_order_release);
      return false;
    }
    error = make_report(ErrorClass::non_fatal, ErrorCode::busy, "a recovery is under way");
  } else if (command.kind == CommandKind::set_outputs) {
    error = take_outputs(command.outputs);
  } else if (command.kind != CommandKind::query) {
    error = refuse(command);
    if (!bad(error) && command.kind == CommandKind::set_tool) {
      tool_ = command.pose;
      planner_.use(ToolKinematics(models_.at(model_), tool_));
      answer(number, {}, reply);
      return true;
    }
    Outstanding* entry = free_place();
    if (!bad(error)) {
      if (entry == nullptr) {
        error = make_report(ErrorClass::non_fatal, ErrorCode::busy, "one command runs and one waits already");
      } else {
        entry->used = true;
        entry->replied = entry->late = entry->after_force = false;
        entry->ticket = ++last_ticket_;
        entry->number = number;
        entry->command = command;
        entry->interruptions = interruptions_told_;
        error = hand_over(*entry);
        if (!bad(error)) {
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

ErrorReport Effector::take_outputs(const ControllerIo& outputs) noexcept {
  const ErrorReport error = refusal_of_outputs(outputs);
  if (bad(error) || channel_.outputs.push(outputs)) return error;
  return make_report(ErrorClass::non_fatal, ErrorCode::busy, "outputs that the servo has not taken yet");
}

/// The answer to a motion or change that is not possible; it also reports an interruption.
ErrorReport Effector::refuse(const RobotCommand& command) noexcept {
  const ErrorReport error = refusal(command);
  if (bad(error)) interruptions_told_ = snapshot_->interruptions;
  return error;
}

Effector::Outstanding* Effector::free_place() noexcept {
  for (Outstanding& entry : outstanding_)
    if (!entry.used) return &entry;
  return nullptr;
}

ErrorReport Effector::hand_over(Outstanding& entry) noexcept {
  const RobotCommand& command = entry.command;
  const bool moves = is_motion(command.kind);
  const bool given_up = command.stop.group != 0 && command.stop.group == snapshot_->given_up;
  // one of a motion that has been given up, or that was to continue it, finds the robot at rest, as if it were late
  if ((unreported_ || joined_ || given_up) && moves && !entry.late) {
    entry.late = true;
    ++counters_.late;
  }

  if (forced_ && (command.kind != CommandKind::force || command.start_tick > end_tick_)) {
    entry.after_force = true;
    macrostep_.kind = Macrostep::Kind::unplanned;
    macrostep_.ticket = entry.ticket;
    macrostep_.epoch = epoch_;
    macrostep_.start = 0;
    channel_.macrosteps.push(macrostep_);
    return {};
  }

  DesiredState from = end_;
  Tick at = from.at_rest() ? std::max(end_tick_, snapshot_->tick) : end_tick_;
  const bool stop_first = !from.at_rest() && (command.start_tick > at || is_change(command.kind));
  if (stop_first) {
    planner_.plan_stop(from, 1, stop_);
    stop_.ticket = 0;
    stop_.epoch = epoch_;
    stop_.stop = {.group = command.stop.group};
    stop_.start = at;
    from = stop_.to;
    at += stop_.steps;
  }
  if (is_change(command.kind)) {
    macrostep_.kind = kind_of(command.kind);
    macrostep_.stop = {};
    macrostep_.choice = command.choice;
    if (mount_) macrostep_.load = {command.load.mass, mount_->inverse() * (tool_ * command.load.centre)};
    macrostep_.steps = macrostep_.reply_step = 1;
    macrostep_.from = macrostep_.to = from;
  } else {
    const Pace pace = entry.late || entry.after_force ? Pace::stretched : Pace::as_commanded;
    const bool holds = given_up || (entry.late && command.stop.ticks > 0);
    const ErrorReport error = planner_.plan(holds ? hold_instead_of(command) : command, from, pace, macrostep_);
    if (bad(error)) return error;
  }
  if (moves && macrostep_.steps > command.motion_steps) ++counters_.stretched;
  macrostep_.ticket = entry.ticket;
  macrostep_.epoch = epoch_;
  macrostep_.with_outputs = moves && command.with_outputs;
  macrostep_.outputs = command.outputs;
  macrostep_.start = command.first_tick(at, 0);
  if (stop_first) channel_.macrosteps.push(stop_);
  channel_.macrosteps.push(macrostep_);
  end_ = macrostep_.to;
  end_tick_ = macrostep_.start + macrostep_.steps;
  entry.start = macrostep_.start;
  entry.end = end_tick_;
  entry.epoch = epoch_;
  forced_ = macrostep_.kind == Macrostep::Kind::force;
  holding_ = command.kind == CommandKind::hold;
  return {};
}

/// When the servo has its own thread, a resting robot begins a tick later than planned when that tick has begun
/// meanwhile; the motions that follow at once are also a tick later.
void Effector::begun(Outstanding& entry, Tick start) noexcept {
  if (start <= entry.start) return;
  const Tick delay = start - entry.start, end = entry.end;
  entry.start += delay;
  entry.end += delay;
  if (end_tick_ == end) end_tick_ = entry.end;
  for (Outstanding& next : outstanding_) {
    if (!next.used || next.ticket <= entry.ticket || next.start != end) continue;
    next.start += delay;
    next.end += delay;
    end_tick_ = next.end;
  }
}

bool Effector::poll_recovery(Reply& reply) noexcept {
  refresh();
  if (!recovery_.under_way || snapshot_ == nullptr || snapshot_->orders == recovery_.orders) return false;
  recovery_.under_way = false;
  answer(recovery_.number, {}, reply);  // it contains a fault that has returned
  return true;
}

bool Effector::poll(Reply& reply) noexcept {
  if (recovery_.under_way && poll_recovery(reply)) return true;
  while (const Report* report = channel_.reports.front()) {
    refresh();  // after the report was seen, so that the snapshot is at least as new
    Outstanding* entry = nullptr;
    for (Outstanding& candidate : outstanding_)
      if (candidate.used && candidate.ticket == report->ticket) entry = &candidate;
    const Report::Kind kind = report->kind;
    bool answered = entry != nullptr;
    if (entry != nullptr && kind == Report::Kind::refused) {
      ErrorReport error = refuse(entry->command);
      if (!bad(error) && snapshot_->interruptions != entry->interruptions)
        error = snapshot_->interruption;  // reported to the previous command; its sender had not received it
      if (!bad(error)) error = hand_over(*entry);
      answered = bad(error);
      if (answered) {
        entry->used = false;
        answer(entry->number, error, reply);
      }
    } else if (entry != nullptr) {
      const Snapshot& then = report->snapshot;
      reply.command = entry->number;
      if (kind == Report::Kind::reply) {
        macrostep_start_ = report->start;
        if (then.epoch == epoch_ && entry->epoch == epoch_) begun(*entry, report->start);
      }
      fill(then, then.end, then.end_tick, reply.state);
      if (kind == Report::Kind::aborted && then.fault.code == ErrorCode::none) {
        const bool interrupted = then.interruptions != interruptions_told_;
        reply.state.error =
            interrupted ? then.interruption
                        : make_report(ErrorClass::non_fatal, ErrorCode::not_enabled, "the drives were switched off");
      }
      if (kind == Report::Kind::aborted) interruptions_told_ = then.interruptions;
      if (then.epoch == epoch_) unreported_ = joined_ = false;
      entry->replied = true;
    }
    channel_.reports.pop();
    if (answered) return true;
  }
  return false;
}

}  // namespace mrroc::edp
