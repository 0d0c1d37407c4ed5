#include "cli/operator/operator_events.hpp"

#include <algorithm>
#include <iterator>
#include <string_view>
#include <utility>

#include "config/entries/robot_orders.hpp"

namespace mrroc::cli {

namespace {

/// Orders that power or move a robot.
constexpr std::string_view kMotions[]{"jog", "step", "go", "synchronise", "recover", "follow"};

constexpr Tick kTicksToCheck = 1, kTicksToCheckInRealTime = 2;  // after a press: every servo has then checked it

}  // namespace

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
                               AnswerLinks& answers, RobotOrders& robots, Trajectories& trajectories, bool real)
    : schedule_(std::move(schedule)),
      emergency_stop_(emergency_stop),
      mp_(mp),
      answers_(answers),
      robots_(robots),
      trajectories_(trajectories),
      real_(real) {}

void OperatorEvents::schedule(const config::Deployment& deployment, bool hold) {
  const auto at = [this](const config::Event& event) {
    schedule_.at_tick(event.tick, [this, event](Tick tick) {
      if (event.command == "estop") ++stops_given_;
      perform(event, tick, 0, stops_given_);
    });
  };
  const auto starts = [](const config::Event& event) { return event.command == "start"; };
  phase_ = TaskPhase::held;
  if (!hold && std::none_of(deployment.events.begin(), deployment.events.end(), starts)) at({.command = "start"});
  for (const config::Event& event : deployment.events) at(event);
}

std::uint64_t OperatorEvents::give(const config::Event& event) {
  const std::uint64_t ticket = ++tickets_;
  if (event.command == "estop") ++stops_given_;
  const std::uint64_t stops = stops_given_;
  if (real_ && event.command == "estop")
    perform(event, schedule_.now(), ticket, stops);
  else
    schedule_.at_tick(schedule_.now() + 1,
                      [this, event, ticket, stops](Tick tick) { perform(event, tick, ticket, stops); });
  return ticket;
}

std::vector<OperatorEvents::Performed> OperatorEvents::take_performed() {
  const std::lock_guard lock(mutex_);
  return std::exchange(performed_, {});
}

/// The stop and the reset reach another host on another path than an order, which a robot there could obey before them.
OperatorEvents::Refused OperatorEvents::check_order(const std::string& command) const {
  if (std::find(std::begin(kMotions), std::end(kMotions), command) == std::end(kMotions)) return {};
  if (emergency_stopped_) return {"the emergency stop is pressed or not reset", "'reset' before"};
  if (!arrived_()) return {"the reset of the emergency stop has not reached every host", "the reply to 'reset' before"};
  return {};
}

Tick OperatorEvents::tick_of_reset(Tick tick) {
  if (!emergency_stopped_) return tick;
  if (!press_arrived_) {
    if (!arrived_()) return tick + 1;
    press_arrived_ = tick;
  }
  return std::max(tick, *press_arrived_ + (real_ ? kTicksToCheckInRealTime : kTicksToCheck));
}

void OperatorEvents::press(Tick tick) {
  emergency_stop_.press();
  ++stops_performed_;
  emergency_stopped_ = true;
  press_arrived_.reset();
  if (arrived_()) press_arrived_ = tick;
}

void OperatorEvents::perform(config::Event event, Tick tick, std::uint64_t ticket, std::uint64_t stops) {
  const std::lock_guard lock(mutex_);
  event.tick = tick;
  std::uint64_t number = 0;
  Refused refused;
  if (config::is_robot_order(event.command)) {
    refused = check_order(event.command);
    if (refused.text == nullptr) number = robots_.send(event.command, event.order, phase_ == TaskPhase::paused);
  } else if (event.command == "follow") {
    refused = check_order(event.command);
    if (refused.text == nullptr) number = follow(event, tick);
  } else if (event.command == "cancel") {
    trajectories_.cancel(event.order.robot);
  } else if (event.command == "answer") {
    answers_.at(event.asker)->answer({event.question, event.value});
  } else if (event.command == "speed") {
    speed_ = event.value / 100;
    mp_.send_speed(speed_);
  } else if (event.command == "estop") {
    press(tick);
  } else if (event.command == "reset") {
    // a servo that sees a press and its reset together stays stopped: the reset waits until the press has been seen
    if (stops_performed_ > stops) {
      refused = {"the emergency stop was requested again", "another 'reset'"};
    } else if (const Tick later = tick_of_reset(tick); later > tick) {
      schedule_.at_tick(later, [this, event, ticket, stops](Tick now) { perform(event, now, ticket, stops); });
      return;
    } else {
      emergency_stop_.reset();
      emergency_stopped_ = false;
    }
  } else {
    command_task(event.command);
  }
  if (refused.text == nullptr) report_(event);
  performed_.push_back({std::move(event), ticket, number, refused});
}

std::uint64_t OperatorEvents::follow(const config::Event& event, Tick tick) {
  const std::uint64_t number = trajectories_.begin();
  send_part(event, number, 0, tick);
  return number;
}

void OperatorEvents::send_part(const config::Event& event, std::uint64_t number, std::size_t index, Tick tick) {
  trajectories_.send(event.order.robot, number, *event.trajectory, index);
  if (++index < Trajectories::parts_of(*event.trajectory))
    schedule_.at_tick(tick + 1, [this, event, number, index](Tick now) { send_part(event, number, index, now); });
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
