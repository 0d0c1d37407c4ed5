#include "edp/command/operator_motion.hpp"

#include <algorithm>
#include <cmath>

#include "edp/safety/error_report.hpp"
#include "geometry/rigid_motion.hpp"

namespace mrroc::edp {

namespace {

constexpr double kMargin = 1.1;       // pieces of a path take a little more than the whole path
constexpr int kSlowings = 4;          // by half, near a limit
constexpr double kDifference = 1e-3;  // s, of a motor velocity

bool is_velocity(const RobotCommand& command) noexcept {
  return command.kind == CommandKind::joint_velocity || command.kind == CommandKind::twist ||
         (command.kind == CommandKind::motor && command.joints.size() == 0);
}

bool is_travel(const RobotCommand& command) noexcept {
  return command.kind == CommandKind::joint || command.kind == CommandKind::motor || command.kind == CommandKind::pose;
}

ErrorReport busy(const char* reason) noexcept { return make_report(ErrorClass::non_fatal, ErrorCode::busy, reason); }

}  // namespace

OperatorMotion::OperatorMotion(Effector& effector, const ModelSet& models, double period)
    : effector_(effector), models_(models), period_(period), planner_(models.at(0), period) {}

Tick OperatorMotion::ticks(double seconds) const noexcept { return static_cast<Tick>(std::lround(seconds / period_)); }

bool OperatorMotion::accept_of_task(const RobotCommand& command, std::uint64_t number, Tick now) noexcept {
  if (command.kind == CommandKind::query) return false;
  if (command.kind == CommandKind::hold && phase_ != Phase::yielded) {
    RobotState state;
    const bool moved_here = phase_ != Phase::idle;
    if (moved_here) task_hold_ = TaskHold{number, now + command.reply_step};
    if (moved_here || (effector_.peek(state) && state.at_rest())) {
      last_task_hold_ = now;
      return moved_here;
    }
  }
  last_task_command_ = now;
  if (phase_ != Phase::jog && phase_ != Phase::travel && phase_ != Phase::stop) return false;
  if (is_change(command.kind)) {
    phase_ = Phase::yielded;  // the reply to the last macrostep ends it
    return false;
  }
  // planned from where the robot no longer is: it comes to rest and holds, and the task plans anew
  effector_.count_late_command();
  if (phase_ != Phase::stop) stop();
  RobotCommand hold;
  hold.kind = CommandKind::hold;
  hold.motion_steps = command.motion_steps;
  hold.reply_step = command.reply_step;
  task_motion_ = TaskMotion{hold, number};
  return true;
}

/// A hold of the task may run and another one wait: then the motion begins after the first.
ErrorReport OperatorMotion::begin(const ErrorReport& error) noexcept {
  begins_ = error.code == ErrorCode::busy;
  return begins_ ? ErrorReport{} : error;
}

bool OperatorMotion::update(Tick now, Reply& reply) noexcept {
  if (!begins_ || (phase_ != Phase::jog && phase_ != Phase::travel)) return false;
  const ErrorReport error = begin(phase_ == Phase::jog ? next_jog_step(now) : next_travel_step());
  if (!bad(error)) return false;
  phase_ = Phase::idle;
  if (!awaited_) return false;
  answer(*awaited_, error, reply);
  awaited_.reset();
  return true;
}

bool OperatorMotion::pass_on(Reply& reply) noexcept {
  if (!task_motion_ || phase_ != Phase::idle || !effector_.has_place()) return false;
  const bool answered = effector_.accept(task_motion_->command, task_motion_->number, reply);
  task_motion_.reset();
  return answered;
}

bool OperatorMotion::poll_hold(Tick now, Reply& reply) noexcept {
  if (!task_hold_ || now < task_hold_->due) return false;
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
    if (phase_ == Phase::jog || phase_ == Phase::travel) stop();
  } else if (is_velocity(command)) {
    error = jog(command, now);
  } else if (is_travel(command)) {
    error = plan_travel(command);
    if (!bad(error)) error = begin(next_travel_step());
    if (!bad(error)) phase_ = Phase::travel;
    if (!bad(error)) awaited_ = number;
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
  const auto recent = [&](const std::optional<Tick>& tick) { return tick && now < *tick + ticks(kTaskIdle); };
  const bool paused = command.choice == kTaskPaused && (is_velocity(command) || is_travel(command));
  if (recent(last_task_command_)) return busy("the task commands the robot");
  if (recent(last_task_hold_) && !paused && command.kind != CommandKind::hold)
    return busy("the task holds the robot; it may be moved while the task is paused");
  if (command.kind == CommandKind::hold || command.kind == CommandKind::set_outputs) return {};
  if (phase_ == Phase::change) return busy("a change of the robot is under way");
  if (phase_ == Phase::travel) return busy("the robot travels to its goal");
  if (awaited_) return busy("the robot comes to rest");
  if (!is_velocity(command) && phase_ != Phase::idle) return busy("the robot jogs");
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

/// The duration follows from the limits; the path is kept, and commanded in pieces.
ErrorReport OperatorMotion::plan_travel(const RobotCommand& command) noexcept {
  RobotState state;
  if (!effector_.peek(state)) return busy("the servo has not ticked yet");
  if (!state.at_rest()) return busy("the robot moves");
  planner_.use(ToolKinematics(models_.at(effector_.snapshot()->model), state.tool));
  planner_.stand_on(effector_.snapshot()->switches);
  RobotCommand whole = command;
  whole.motion_steps = kSteps;
  whole.reply_step = 1;
  whole.joint_velocity.resize(0);
  whole.joint_acceleration.resize(0);
  whole.twist.setZero();
  whole.start_tick = 0;
  if (command.kind == CommandKind::pose && command.relative && !command.twist.isZero(0)) {
    whole.relative = false;
    whole.pose = state.desired_pose;
    whole.pose.translation() += command.twist.head<3>();
    whole.pose.linear() = exp_rotation(command.twist.tail<3>()) * state.desired_pose.linear();
  }
  const DesiredState from = DesiredState::resting_at(state.desired_joints);
  if (const ErrorReport error = planner_.plan(whole, from, Pace::stretched, travel_); bad(error)) return error;
  slowness_ = kMargin;
  duration_ = static_cast<std::uint32_t>(std::ceil(travel_.steps * slowness_));
  travelled_ = 0;
  return {};
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
  const std::uint32_t steps = std::min<std::uint32_t>(kSteps, duration_ - travelled_);
  const std::uint32_t end = travelled_ + steps;
  step_ = RobotCommand{};
  step_.kind = CommandKind::joint;
  step_.motion_steps = static_cast<std::uint16_t>(steps);
  step_.reply_step = static_cast<std::uint16_t>(end == duration_ ? steps + 1 : std::max<std::uint32_t>(1, steps - 2));
  DesiredState goal = travel_.to;
  if (end < duration_) {
    const double t = end * period_ / slowness_;
    if (const ErrorCode code = travel_.path.at(t, travel_.from.position, goal); code != ErrorCode::none)
      return make_report(ErrorClass::non_fatal, code, "on the path, at tick %u", end);
    step_.joint_velocity = goal.velocity / slowness_;
    step_.joint_acceleration = goal.acceleration / (slowness_ * slowness_);
  }
  step_.joints = goal.position;
  if (const ErrorReport error = send(step_); bad(error)) return error;
  travel_.from.position = goal.position;  // the inverse kinematics continues from there
  travelled_ = end;
  return {};
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
      if (!ends && travelled_ < duration_) {
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
