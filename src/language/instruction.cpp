#include "language/instruction.hpp"

#include <algorithm>
#include <utility>

#include "language/instruction_lists.hpp"
#include "language/stops/common_stop.hpp"
#include "mrroc/fnv.hpp"
#include "mrroc/stopped.hpp"
#include "mrroc/superior.hpp"

namespace mrroc {

namespace {

/// Length of a step without robots: the original's macrostep.
constexpr Tick kStepWithoutRobots = 10;

bool ends_in_motion(const RobotCommand& command) {
  switch (command.kind) {
    case CommandKind::joint:
    case CommandKind::motor:
    case CommandKind::joint_velocity:
      return !command.joint_velocity.isZero(0);
    case CommandKind::pose:
    case CommandKind::twist:
      return !command.twist.isZero(0);
    default:
      return false;
  }
}

/// The robot should continue to move but reports that it comes to rest: no command came in time.
bool has_braked(const Robot& robot) { return ends_in_motion(robot.command()) && robot.state().at_rest(); }

/// Declared before the instruction's own ends, so that these come first.
struct FinishOfGenerator {
  Generator*& generator;
  explicit FinishOfGenerator(Generator*& started) : generator(started) {}
  FinishOfGenerator(const FinishOfGenerator&) = delete;
  FinishOfGenerator& operator=(const FinishOfGenerator&) = delete;
  ~FinishOfGenerator() {
    if (generator != nullptr) generator->finish();
  }
};

StepEnding ending_of(ErrorClass error_class) {
  if (error_class == ErrorClass::non_fatal) return StepEnding::non_fatal_error;
  return error_class == ErrorClass::hardware ? StepEnding::hardware_error : StepEnding::system_error;
}

StepEnding ending_of(Ending ending) {
  if (ending == Ending::condition) return StepEnding::condition;
  return ending == Ending::generator ? StepEnding::generator : StepEnding::end_motion;
}

}  // namespace

Instruction::Instruction(const RobotList& robots, const SensorList& sensors, Generator* generator,
                         std::shared_ptr<Condition> condition)
    : robots_(robots.begin(), robots.end()),
      sensors_(sensors.begin(), sensors.end()),
      generator_(generator),
      condition_(std::move(condition)),
      task_(&task_of(robots_, sensors_)),
      speed_(robots_, generator_) {
  if (condition_) condition_->append_leaves(leaves_);
}

Outcome Instruction::run() {
  const ExclusiveUse use(robots_, sensors_);
  const FinishOfGenerator finish{started_};
  begin_record();
  join_superior();
  try {
    Outcome outcome = run_steps();
    end_coordination();
    leave_superior(nullptr);
    return outcome;
  } catch (Error& error) {
    error.complete_origin({task_->process_name(), "", step_, newest_tick()});
    observe(ending_of(error.error_class()));
    error.attach(std::make_shared<const BlackBox>(task_->black_box()));  // before other fibers of the task add to it
    end_after(error);
    throw;
  } catch (const Stopped&) {
    observe(StepEnding::stopped);
    leave_superior(nullptr);
    throw;
  } catch (...) {
    observe(StepEnding::system_error);
    leave_superior(nullptr);
    throw;
  }
}

Outcome Instruction::run_steps() {
  start_wall_ = task_->wall_seconds();
  obtain_initial_state();
  start_tick_ = newest_tick();
  name_group();
  throw_reported_errors();
  if (condition_) condition_->start();
  speed_.begin();
  if (generator_ != nullptr) {
    const SpeedOverride::OwnTime own_time(speed_);
    started_ = generator_;
    generator_->start();
    leads_ = true;
  }
  late_ = late_commands();
  for (;;) {
    if (superior_ == nullptr) resume_after_late_command();
    if (operator_ends_it()) {
      observe(StepEnding::end_motion);
      return finish(Ending::end_motion);
    }
    if (superior_ != nullptr && !superior_commands()) continue;
    if (const std::optional<Ending> ending = evaluate_end()) {
      observe(ending_of(*ending));
      return finish(*ending);
    }
    if (superior_ != nullptr && superior_->ended()) continue;
    write_next_state();
    send(step_ + 1);
    observe(StepEnding::none);
    receive(step_ + 1);
    measure_skew();
    if (superior_ != nullptr) superior_->answer(robots_[0]->state());
    ++step_;
    throw_reported_errors();
  }
}

void Instruction::obtain_initial_state() {
  for (Robot* robot : robots_) robot->reset_command(CommandKind::query);
  for (Sensor* sensor : sensors_) sensor->initiate_reading(0);
  for (Robot* robot : robots_) robot->send();
  for (Robot* robot : robots_) robot->receive();
  for (Sensor* sensor : sensors_) sensor->collect_reading();
}

void Instruction::throw_reported_errors() const {
  const ErrorReport* most_severe = nullptr;
  const std::string* device = nullptr;
  Tick tick = 0;
  const auto check = [&](const ErrorReport& error, const std::string& name, Tick when) {
    if (error.error_class <= (most_severe != nullptr ? most_severe->error_class : ErrorClass::none)) return;
    most_severe = &error;
    device = &name;
    tick = when;
  };
  for (const Robot* robot : robots_) check(robot->state().error, robot->name(), robot->state().tick);
  for (const Sensor* sensor : sensors_) check(sensor->reading().error, sensor->name(), sensor->reading().tick);
  if (most_severe == nullptr) return;
  throw_error(most_severe->error_class, most_severe->code, std::string{most_severe->detail.view()},
              {task_->process_name(), *device, step_, tick});
}

void Instruction::resume_after_late_command() {
  const std::uint64_t before = std::exchange(late_, late_commands());
  const auto late = [this](const Robot* robot) {
    return has_braked(*robot) || timing_.missed_by(*robot) || robot->state().coordination == Coordination::left;
  };
  if (late_ == before && std::none_of(robots_.begin(), robots_.end(), late)) return;
  timing_.allow_more_time();
  if (!sensors_.empty() && newest_state() > measure_at_) hold();  // the readings were requested before the delay
  come_to_rest();
  late_ = late_commands();
  end_braking();
  if (generator_ != nullptr) resume_generator();
}

void Instruction::resume_generator() {
  name_group();
  obtain_if_coordinated();
  speed_.begin();
  generator_->resume();
}

std::uint64_t Instruction::late_commands() const noexcept {
  std::uint64_t count = 0;
  for (const Robot* robot : robots_) count += robot->state().late_commands;
  return count;
}

std::optional<Ending> Instruction::evaluate_end() {
  const bool condition_holds = condition_ != nullptr && condition_->evaluate();
  const bool generator_ends = generator_ != nullptr && speed_.due() && generator_->terminal_condition();
  if (condition_holds) return Ending::condition;
  if (generator_ends) return Ending::generator;
  return std::nullopt;
}

void Instruction::write_next_state() {
  if (superior_ != nullptr) return write_with_superior();
  for (Robot* robot : robots_) robot->reset_command(CommandKind::hold);
  if (generator_ != nullptr && speed_.due()) {
    const SpeedOverride::OwnTime own_time(speed_);
    generator_->next_state();
  }
  speed_.write(halting_ ? 0 : braking_ ? 1 : task_->operator_speed());
  stop_together();
  timing_.plan(robots_, task_->tick());
}

/// Should the next commands be late, or one of the robots stop alone.
void Instruction::stop_together() noexcept {
  if (robots_.size() < 2) return;
  const CommonStop stop = common_stop(robots_, task_->servo_period());
  for (Robot* robot : robots_) robot->command().stop = {stop.ticks, stop.rate, group_};
}

/// Of the motion that begins now: no other one of these robots begins in this tick.
void Instruction::name_group() noexcept {
  if (robots_.size() < 2) return;
  group_ = Fnv1a{}.add(robots_[0]->name()).add(task_->process_name()).add(task_->tick()).value();
}

void Instruction::measure_skew() noexcept {
  if (robots_.empty()) return;
  Tick first = kNever, last = 0;
  for (const Robot* robot : robots_) {
    first = std::min(first, robot->state().macrostep_start);
    last = std::max(last, robot->state().macrostep_start);
  }
  skew_ = std::max(skew_, last - first);
}

Tick Instruction::next_measurement() const {
  const Tick now = task_->tick();
  if (robots_.empty()) return now + kStepWithoutRobots;
  Tick tick = 0;
  for (const Robot* robot : robots_)
    tick = std::max(tick, robot->command().reply_tick(robot->state().desired_tick, now));
  return tick;
}

void Instruction::send(std::uint64_t next_step) {
  measure_at_ = next_measurement();
  for (Sensor* sensor : sensors_) {
    if (sensor->due(next_step)) sensor->initiate_reading(measure_at_);
  }
  for (Robot* robot : robots_) robot->send();
}

void Instruction::receive(std::uint64_t next_step) {
  for (Robot* robot : robots_) robot->receive();
  if (robots_.empty()) task_->sleep_until(measure_at_);
  for (Sensor* sensor : sensors_) {
    if (sensor->due(next_step)) sensor->collect_reading();
  }
}

Tick Instruction::newest_state() const noexcept {
  Tick tick = 0;
  for (const Robot* robot : robots_) tick = std::max(tick, robot->state().tick);
  return tick;
}

Tick Instruction::newest_tick() const {
  Tick tick = newest_state();
  for (const Sensor* sensor : sensors_) tick = std::max(tick, sensor->reading().tick);
  return tick;
}

Outcome Instruction::finish(Ending ending) const {
  Outcome outcome;
  outcome.ending = ending;
  outcome.steps = step_;
  outcome.start_tick = start_tick_;
  outcome.end_tick = newest_tick();
  outcome.skew = skew_;
  outcome.duration = static_cast<double>(outcome.end_tick - start_tick_) * task_->servo_period();
  outcome.wall_duration = task_->wall_seconds() - start_wall_;
  if (ending == Ending::condition) {
    outcome.condition = condition_;
    condition_->append_reasons(outcome.reasons);
  }
  return outcome;
}

Outcome Move(const RobotList& robots, const SensorList& sensors, Generator& generator) {
  return Instruction(robots, sensors, &generator, generator.condition()).run();
}

Outcome Wait(const RobotList& robots, const SensorList& sensors, std::shared_ptr<Condition> condition) {
  if (condition == nullptr) throw NonFatalError(ErrorCode::invalid_argument, "Wait needs a condition");
  return Instruction(robots, sensors, nullptr, std::move(condition)).run();
}

}  // namespace mrroc
