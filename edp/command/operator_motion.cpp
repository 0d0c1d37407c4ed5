#include "edp/command/operator_motion.hpp"

#include <algorithm>
#include <cmath>

#include "edp/command/order_kind.hpp"
#include "edp/safety/error_report.hpp"

namespace mrroc::edp {

namespace {

constexpr int kSlowings = 4;          // by half, near a limit
constexpr double kDifference = 1e-3;  // s, of a motor velocity

/// The end of the macrostep of a task's command that has come at tick `now`.
Tick end_of(const RobotCommand& command, Tick now) noexcept {
  return std::clamp(command.start_tick, now, now + kMaxMotionSteps) + command.motion_steps;
}

ErrorReport busy(const char* reason) noexcept { return make_report(ErrorClass::non_fatal, ErrorCode::busy, reason); }

}  // namespace

OperatorMotion::OperatorMotion(Effector& effector, const ModelSet& models, double period)
    : effector_(effector), models_(models), period_(period), travel_(models, period) {}

Tick OperatorMotion::ticks(double seconds) const noexcept { return static_cast<Tick>(std::lround(seconds / period_)); }

bool OperatorMotion::accept_of_task(const RobotCommand& command, std::uint64_t number, Tick now) noexcept {
  const bool moves = phase_ == Phase::jog || phase_ == Phase::travel || phase_ == Phase::stop;
  if (command.kind == CommandKind::query) {
    if (!moves) return false;
    // the task plans from the state that it gets: from rest
    end_motion();
    task_hold_ = TaskHold{number, 0, true};
    return true;
  }
  if (command.kind == CommandKind::hold && phase_ != Phase::yielded) {
    RobotState state;
    const bool moved_here = phase_ != Phase::idle;
    if (moved_here) task_hold_ = TaskHold{number, now + command.reply_step, false};
    if (moved_here || (effector_.peek(state) && state.at_rest())) {
      task_holds_until_ = end_of(command, now);
      return moved_here;
    }
  }
  task_commands_until_ = end_of(command, now);
  if (next_travel_) next_travel_->ended = true;
  if (!moves) return false;
  if (is_change(command.kind)) {
    phase_ = Phase::yielded;  // the reply to the last macrostep ends it
    return false;
  }
  // planned from where the robot no longer is: it comes to rest and holds, and the task plans again
  effector_.count_late_command();
  end_motion();
  late_motion_ = LateMotion{{}, number};
  late_motion_->hold.kind = CommandKind::hold;
  late_motion_->hold.motion_steps = command.motion_steps;
  late_motion_->hold.reply_step = command.reply_step;
  return true;
}

/// A hold of the task may run and another one wait: then the motion begins after the first.
ErrorReport OperatorMotion::begin(const ErrorReport& error) noexcept {
  begins_ = error.code == ErrorCode::busy;
  return begins_ ? ErrorReport{} : error;
}

bool OperatorMotion::update(Tick now, Reply& reply) noexcept {
  if (next_travel_ && (next_travel_->ended || phase_ == Phase::idle)) {
    const NextTravel next = *std::exchange(next_travel_, std::nullopt);
    const ErrorReport error =
        next.ended ? busy("the motion was ended before it began") : travel(next.command, next.number);
    if (bad(error)) answer(next.number, error, reply);
    return bad(error);
  }
  if (!begins_ || (phase_ != Phase::jog && phase_ != Phase::travel)) return false;
  const ErrorReport error = begin(phase_ == Phase::jog ? next_jog_step(now) : next_travel_step());
  if (!bad(error)) return false;
  phase_ = Phase::idle;
  if (!awaited_) return false;
  answer(*awaited_, error, reply);
  awaited_.reset();
  return true;
}

bool OperatorMotion::hold_for_late_motion(Reply& reply) noexcept {
  if (!late_motion_ || phase_ != Phase::idle || !effector_.has_place()) return false;
  const bool answered = effector_.accept(late_motion_->hold, late_motion_->number, reply);
  late_motion_.reset();
  return answered;
}

bool OperatorMotion::poll_hold(Tick now, Reply& reply) noexcept {
  if (!task_hold_ || (task_hold_->until_rest ? phase_ != Phase::idle : now < task_hold_->due)) return false;
  answer(task_hold_->number, {}, reply);
  task_hold_.reset();
  return true;
}

bool OperatorMotion::accept(const RobotCommand& command, std::uint64_t number, Tick now, Reply& reply) noexcept {
  ErrorReport error = command.kind == CommandKind::query ? ErrorReport{} : refusal(command, now);
  if (bad(error) || command.kind == CommandKind::query) {
    answer(number, error, reply);
    return true;
  }
  if (command.kind == CommandKind::hold) {
    end_motion();
  } else if (is_jog(command)) {
    error = jog(command, now);
  } else if (is_travel(command)) {
    if (phase_ == Phase::stop) {
      next_travel_ = NextTravel{command, number, false};
      return false;
    }
    error = travel(command, number);
  } else {
    step_ = command.kind == CommandKind::set_outputs ? with_one_output(command) : command;
    if (effector_.accept(step_, kOwn | ++sent_, reply)) {
      reply.command = number;
      return true;
    }
    phase_ = Phase::change;
    awaited_ = number;
  }
  if (!bad(error) && awaited_ == number) return false;
  answer(number, error, reply);
  return true;
}

ErrorReport OperatorMotion::refusal(const RobotCommand& command, Tick now) const noexcept {
  const auto recent = [&](const std::optional<Tick>& until) { return until && now < *until + ticks(kTaskIdle); };
  const bool moves = is_jog(command) || is_travel(command);
  if (recent(task_commands_until_)) return busy("the task commands the robot");
  if (recent(task_holds_until_) && !(moves && command.choice == kTaskPaused) && command.kind != CommandKind::hold)
    return busy(moves ? "the task holds the robot; it may be moved while the task is paused"
                      : "the task holds the robot, also while paused: only jog, step and go are possible then");
  if (command.kind == CommandKind::hold || command.kind == CommandKind::set_outputs) return {};
  if (phase_ == Phase::change) return busy("a change of the robot is under way");
  if (phase_ == Phase::travel) return busy("the robot travels to its goal");
  if (next_travel_) return busy("the robot comes to rest, then it travels");
  if (phase_ == Phase::stop && is_travel(command)) return {};
  if (awaited_) return busy("the robot comes to rest");
  if (!is_jog(command) && phase_ != Phase::idle) return busy("the robot jogs");
  return {};
}

ErrorReport OperatorMotion::travel(const RobotCommand& command, std::uint64_t number) noexcept {
  ErrorReport error = travel_.plan(command, effector_);
  if (!bad(error)) error = begin(next_travel_step());
  if (bad(error)) return error;
  phase_ = Phase::travel;
  awaited_ = number;
  return {};
}

/// A motor velocity of a synchronised robot becomes the joint velocity that it causes at this posture.
ErrorReport OperatorMotion::jog(const RobotCommand& command, Tick now) noexcept {
  const Snapshot* const snapshot = effector_.snapshot();
  if (snapshot == nullptr) return busy("the servo has not ticked yet");
  RobotCommand wanted = command;
  if (command.kind == CommandKind::motor) {
    wanted.kind = CommandKind::joint_velocity;
    wanted.interpolation = Interpolation::motors;
    if (command.joint_velocity.size() != snapshot->end.position.size())
      return make_report(ErrorClass::non_fatal, ErrorCode::invalid_argument, "%d motor velocities, expected %d",
                         static_cast<int>(command.joint_velocity.size()),
                         static_cast<int>(snapshot->end.position.size()));
    const RobotModel& model = models_.at(snapshot->model);
    JointVector motors, moved;
    ErrorCode code = model.joints_to_motors(snapshot->end.position, motors);
    if (code == ErrorCode::none) code = model.motors_to_joints(motors + command.joint_velocity * kDifference, moved);
    if (code != ErrorCode::none) return make_report(ErrorClass::non_fatal, code, "the motors at this posture");
    wanted.joint_velocity = (moved - snapshot->end.position) / kDifference;
  }
  const RobotCommand before = std::exchange(velocity_, wanted);
  valid_until_ = now + ticks(kJogValidity);
  if (phase_ == Phase::jog) return {};  // its next macrostep takes the new velocity
  const ErrorReport error = begin(next_jog_step(now));
  if (bad(error))
    velocity_ = before;
  else
    phase_ = Phase::jog;
  return error;
}

/// `begin`: the end of the macrostep before, or now.
ErrorReport OperatorMotion::next_jog_step(Tick begin) noexcept {
  step_ = velocity_;
  const Tick rest = valid_until_ - std::min(valid_until_, begin);
  step_.motion_steps = static_cast<std::uint16_t>(std::clamp<Tick>(rest, 1, kSteps));
  step_.reply_step = static_cast<std::uint16_t>(std::max(1, step_.motion_steps - 2));
  ErrorReport error;
  double scale = 1;
  for (int i = 0; i <= kSlowings; ++i, scale *= 0.5) {
    step_.joint_velocity = velocity_.joint_velocity * scale;
    step_.twist = velocity_.twist * scale;
    error = send(step_);
    if (!bad(error)) break;
  }
  return error;
}

/// The present outputs with the one that the operator changes.
RobotCommand OperatorMotion::with_one_output(const RobotCommand& command) noexcept {
  RobotCommand changed = command;
  RobotState state;
  if (effector_.peek(state)) changed.outputs = state.outputs;
  const int index = command.choice;
  if (index < ControllerIo::kDigital)
    changed.outputs.set(index, command.outputs.on(index));
  else if (index < ControllerIo::kDigital + ControllerIo::kAnalog)
    changed.outputs.analog[static_cast<std::size_t>(index - ControllerIo::kDigital)] =
        command.outputs.analog[static_cast<std::size_t>(index - ControllerIo::kDigital)];
  return changed;
}

ErrorReport OperatorMotion::next_travel_step() noexcept {
  ErrorReport error = travel_.write(step_);
  if (!bad(error)) error = send(step_);
  if (!bad(error)) travel_.commanded();
  return error;
}

void OperatorMotion::end_motion() noexcept {
  if (next_travel_) next_travel_->ended = true;
  if (phase_ == Phase::jog || phase_ == Phase::travel) stop();
}

/// When the effector has two macrosteps already, the reply to the later one tries again.
void OperatorMotion::stop() noexcept {
  step_ = RobotCommand{};
  step_.kind = CommandKind::hold;
  step_.motion_steps = kSteps;
  step_.reply_step = kSteps + 1;
  send(step_);
  phase_ = Phase::stop;
}

ErrorReport OperatorMotion::send(const RobotCommand& command) noexcept {
  if (!effector_.accept(command, kOwn | ++sent_, ignored_)) return {};
  --sent_;  // the reply to the command before is still to come
  return ignored_.state.error;
}

bool OperatorMotion::take(Reply& reply) noexcept {
  if ((reply.command & ~kOwn) != sent_) return false;  // another command has followed it
  const bool ends = bad(reply.state.error);
  ErrorReport error;
  switch (phase_) {
    case Phase::jog:
      if (ends) phase_ = Phase::idle;
      if (!ends && (reply.state.desired_tick >= valid_until_ || bad(next_jog_step(reply.state.desired_tick)))) stop();
      return false;
    case Phase::travel:
      if (!ends && !travel_.over()) {
        error = next_travel_step();
        if (!bad(error)) return false;
        stop();
      } else {
        phase_ = Phase::idle;
      }
      break;
    case Phase::yielded:
      phase_ = Phase::idle;
      if (!ends) error = busy("the task has taken the robot");
      break;
    case Phase::stop:
      if (!ends && !reply.state.at_rest()) {
        stop();
        return false;
      }
      phase_ = Phase::idle;
      if (awaited_ && !ends) error = busy("the motion was ended before its goal");
      break;
    case Phase::change:
    case Phase::idle:
      phase_ = Phase::idle;
      break;
  }
  if (!awaited_) return false;
  reply.command = *awaited_;
  awaited_.reset();
  if (bad(error)) reply.state.error = error;
  return true;
}

void OperatorMotion::answer(std::uint64_t number, const ErrorReport& error, Reply& reply) noexcept {
  reply.command = number;
  reply.state = RobotState{};
  effector_.peek(reply.state);
  if (bad(error)) reply.state.error = error;
}

}  // namespace mrroc::edp
