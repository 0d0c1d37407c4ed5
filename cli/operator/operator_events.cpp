#include "cli/operator/operator_events.hpp"

#include <algorithm>
#include <utility>

#include "config/entries/robot_orders.hpp"

namespace mrroc::cli {

const char* name_of(TaskPhase phase) noexcept {
  switch (phase) {
    case TaskPhase::starting:
      return "starting";
    case TaskPhase::held:
      return "held";
    case TaskPhase::running:
      return "running";
    case TaskPhase::paused:
      return "paused";
    case TaskPhase::stopping:
      return "stopping";
  }
  return "?";
}

OperatorEvents::OperatorEvents(Schedule schedule, clock::EmergencyStop& emergency_stop, links::TaskSuperior& mp,
                               AnswerLinks& answers, RobotOrders& robots, bool real)
    : schedule_(std::move(schedule)),
      emergency_stop_(emergency_stop),
      mp_(mp),
      answers_(answers),
      robots_(robots),
      real_(real) {}

void OperatorEvents::schedule(const config::Deployment& deployment, bool hold) {
  const auto at = [this](const config::Event& event) {
    schedule_.at_tick(event.tick, [this, event](Tick tick) { perform(event, tick, 0); });
  };
  const auto starts = [](const config::Event& event) { return event.command == "start"; };
  phase_ = TaskPhase::held;
  if (!hold && std::none_of(deployment.events.begin(), deployment.events.end(), starts)) at({.command = "start"});
  for (const config::Event& event : deployment.events) at(event);
}

std::uint64_t OperatorEvents::give(const config::Event& event) {
  const std::uint64_t ticket = ++tickets_;
  if (real_ && event.command == "estop")
    perform(event, schedule_.now(), ticket);
  else
    schedule_.at_tick(schedule_.now() + 1, [this, event, ticket](Tick tick) { perform(event, tick, ticket); });
  return ticket;
}

std::vector<OperatorEvents::Performed> OperatorEvents::take_performed() {
  const std::lock_guard lock(mutex_);
  return std::exchange(performed_, {});
}

void OperatorEvents::perform(config::Event event, Tick tick, std::uint64_t ticket) {
  const std::lock_guard lock(mutex_);
  event.tick = tick;
  std::uint64_t number = 0;
  if (config::is_robot_order(event.command)) {
    number = robots_.send(event.command, event.order, phase_ == TaskPhase::paused);
  } else if (event.command == "answer") {
    answers_.at(event.asker)->answer({event.question, event.value});
  } else if (event.command == "speed") {
    speed_ = event.value / 100;
    mp_.send_speed(speed_);
  } else if (event.command == "estop" || event.command == "reset") {
    const bool press = event.command == "estop";
    press ? emergency_stop_.press() : emergency_stop_.reset();
    emergency_stopped_ = press;
  } else {
    command_task(event.command);
  }
  performed_.push_back({std::move(event), ticket, number});
}

void OperatorEvents::command_task(const std::string& command) {
  using links::TaskCommandKind;
  const TaskPhase before = phase_.load();
  if (command == "stop") {
    phase_ = TaskPhase::stopping;
    // a task that has not begun takes no command but `start`
    if (before == TaskPhase::held)
      stopped_before_start_ = true;
    else
      mp_.send(TaskCommandKind::stop);
  } else if (command == "start") {
    if (before != TaskPhase::held) return;
    phase_ = TaskPhase::running;
    mp_.send(TaskCommandKind::start);
  } else if (command == "pause") {
    if (before == TaskPhase::running) phase_ = TaskPhase::paused;
    mp_.send(TaskCommandKind::pause);
  } else if (command == "resume") {
    if (before == TaskPhase::paused) phase_ = TaskPhase::running;
    mp_.send(TaskCommandKind::resume);
  } else {
    mp_.send(TaskCommandKind::trigger);
  }
}

}  // namespace mrroc::cli
