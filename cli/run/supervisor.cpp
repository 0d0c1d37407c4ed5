#include "cli/run/supervisor.hpp"

#include <poll.h>
#include <signal.h>
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <utility>

#include "core/error_text.hpp"
#include "mrroc/errors.hpp"
#include "process/process.hpp"

namespace mrroc::cli {

namespace {

constexpr double kLongestDeath = 10;        // s
constexpr double kPatienceWithCause = 0.5;  // s from a task's report of a loss to its cause

/// Between machines, peers cannot distinguish a dead process from a cut link.
bool tells_of_a_loss(ErrorCode code) { return code == ErrorCode::process_died || code == ErrorCode::link_lost; }

}  // namespace

// SIGTTOU: a terminal may be set to stop background processes that write to it
Supervisor::Supervisor(const Watched& watched)
    : watched_(watched),
      signals_({SIGTSTP, SIGTTOU}),
      heartbeats_(watched.deployment.heartbeat_timeout),
      stall_(watched.clock) {}

void Supervisor::task_starts() {
  const double now = watched_.wall.wall_seconds();
  heartbeats_.expect(names_of(watched_.plan), now);
  started_at_ = now;
  task_started_ = true;
}

void Supervisor::task_ends() {
  if (!task_started_) return;
  result_.wall_seconds = watched_.wall.wall_seconds() - started_at_;
  if (result_.ticks == 0) result_.ticks = watched_.clock.tick();
}

RunResult Supervisor::result() const {
  RunResult result = result_;
  result.statuses = heartbeats_.statuses();
  return result;
}

void Supervisor::guard(const std::function<void()>& step) {
  try {
    step();
  } catch (const std::exception& error) {
    fail(process::exit_code(error), error.what());
  }
}

void Supervisor::supervise() {
  while (turn(kTurn)) {
    check_heartbeats();
    if (const std::string line = stall_.check(watched_.wall.wall_seconds()); !line.empty())
      watched_.progress.message(line);
  }
}

bool Supervisor::turn(int milliseconds) {
  wait(milliseconds);
  read_signals();
  if (links_ != nullptr) read_statuses();
  watched_.faults.tell();
  // causes first: the task's report of a death or a lost clock is only their consequence
  check_stop();
  check_children();
  if (hosts_ != nullptr) hosts_->poll();
  check_clock();
  poll_operator();  // messages from before the end are shown before it
  if (task_started_) read_task_status();
  watched_.progress.draw();
  return !ending_;
}

void Supervisor::read_signals() {
  while (const int number = signals_.take()) {
    if (number == SIGTSTP)
      watched_.progress.message("Ctrl-Z does nothing: robots that move must be watched");
    else if (number != SIGCHLD)
      interrupt_by_operator();
  }
}

void Supervisor::interrupt_by_operator() {
  if (ending_) {
    hurried_ = true;
    return;
  }
  ++interrupts_;
  if (interrupts_ > 1 || !task_started_) {
    fail(process::ExitCode::stopped, "ended by the operator");
    return;
  }
  watched_.progress.message("stopping (once more to end at once)");
  VerbRequest stop;
  stop.verb = find_verb("stop");
  watched_.service.request({0, "Ctrl-C"}, stop, {});
}

void Supervisor::read_statuses() {
  links_->processes.poll();
  for (const auto& [name, process] : links_->processes.processes())
    if (heartbeats_.take(process.status, watched_.wall.wall_seconds())) {
      watched_.progress.update(process.status);
      watched_.service.update(process.status);
    }
}

void Supervisor::await_cause() {
  // the processes of a stopped agent leave before its silence has reached the timeout
  const double silence = watched_.deployment.hosts_used().empty() ? 0 : watched_.deployment.link_timeout;
  const double deadline = watched_.wall.wall_seconds() + kPatienceWithCause + silence;
  while (!ending_ && watched_.wall.wall_seconds() < deadline) {
    wait(kTurn);
    read_signals();
    check_children();
    if (hosts_ != nullptr) hosts_->poll();
    poll_operator();  // an emergency stop must not wait for it
  }
}

void Supervisor::read_task_status() {
  links::TaskStatus status;
  std::uint64_t last_command = 0;
  while (links_->mp.take(status, last_command)) {
    check_children();  // a death may be why the task ends
    if (watched_.faults.ends_run()) continue;
    if (!ending_ && status.state == links::TaskState::failed && tells_of_a_loss(status.error.code)) await_cause();
    // the request came from elsewhere, with a signal to the MP alone: its end is the end of a process
    if (!ending_ && status.state == links::TaskState::stopped && !links_->events.stop_performed()) await_cause();
    if (!ending_) take(status);
  }
}

void Supervisor::take(const links::TaskStatus& status) {
  using links::TaskState;
  if (status.state == TaskState::running || status.state == TaskState::paused) return;
  result_.ticks = status.tick;
  if (status.state == TaskState::failed)
    fail(process::exit_code(status.error.error_class),
         error_text(
             status.error.error_class, status.error.code, std::string{status.error.detail.view()},
             {std::string{status.process.view()}, std::string{status.device.view()}, status.step, status.error_tick}) +
             watched_.black_boxes.reported());
  else if (status.state == TaskState::stopped)
    fail(process::ExitCode::stopped, "stopped by the operator");
  else
    ending_ = true;
}

void Supervisor::wait(int milliseconds) {
  const int socket = socket_ != nullptr ? socket_->descriptor() : -1;
  watched_.group.wait(milliseconds, {descriptor(), socket});
}

void Supervisor::poll_operator() {
  if (socket_ != nullptr) socket_->poll();
  for (SideProcess* const side : sides_) side->poll();
  if (task_started_ && !ending_) {
    console_->poll(watched_.service.may_answer() && socket_ != nullptr && socket_->watched());
    if (console_->takes_keys())
      watched_.progress.prompt(console_->prompt());
    else
      watched_.progress.pause(console_->waits_for_line());
  }
  watched_.service.poll();
  if (socket_ != nullptr && links_ != nullptr) publish_telemetry();
  if (!ending_ && links_ != nullptr && links_->events.stopped_before_start())
    fail(process::ExitCode::stopped, "stopped by the operator before the task's start");
}

void Supervisor::publish_telemetry() {
  const double now = watched_.wall.wall_seconds();
  if (now < next_telemetry_) return;
  next_telemetry_ = now + kTurn * 1e-3;
  const WatchedStates states = socket_->watched_states();
  links_->telemetry.watch(states.robots, states.readings);
  links_->world.watch(states.world);
  for (const std::string& line : links_->telemetry.take_robots()) socket_->publish_robot(line);
  for (const std::string& line : links_->telemetry.take_readings()) socket_->publish_reading(line);
  if (!states.world) return;
  if (const auto line = links_->world.take()) socket_->publish_world(*line);
}

void Supervisor::check_stop() {
  if (!ending_ && watched_.clock.was_stopped())
    fail(process::ExitCode::system,
         "mrroc run itself was stopped by a signal: its robots have braked, its processes left");
}

void Supervisor::check_children() {
  if (ending_) return;
  if (watched_.group.first_lost() == nullptr) return;
  // a second check: the cause came before its effect, but the first check may have been too early
  Child* const child = watched_.group.first_lost(watched_.faults.struck());
  const int code = child->exit_code().value_or(-1);
  const bool left =
      code == static_cast<int>(process::ExitCode::success) || code == static_cast<int>(process::ExitCode::stopped);
  if (left && watched_.clock.failed_with(child->name())) return check_clock();
  std::string how = child->how_it_was_lost();
  if (task_started_)
    how += " [tick " + std::to_string(std::min(watched_.clock.stop_tick(), watched_.clock.tick())) + "]";
  watched_.faults.tell_noticed(child->name());
  watched_.clock.participant_died(child->name());
  process_lost(child->name(), code, how);
}

void Supervisor::process_lost(const std::string& name, int exit_code, const std::string& how) {
  const auto named = [&name](const PlannedProcess& process) { return process.name == name; };
  const auto process = std::find_if(watched_.plan.begin(), watched_.plan.end(), named);
  const bool here = process == watched_.plan.end() || process->host.empty();
  fail(code_of_death(exit_code), "process " + name + (here ? " " : " on host " + process->host + " ") + how);
}

process::ExitCode Supervisor::code_of_death(int exit_code) const {
  // a process that rejects its part of the deployment reports the severity; later the others would miss it
  const bool refused = !task_started_ && exit_code >= static_cast<int>(process::ExitCode::task_failed) &&
                       exit_code <= static_cast<int>(process::ExitCode::hardware);
  return refused ? static_cast<process::ExitCode>(exit_code) : process::ExitCode::system;
}

void Supervisor::check_heartbeats() {
  if (ending_) return;
  const double now = watched_.wall.wall_seconds();
  const std::string name = heartbeats_.silent(now);
  if (name.empty()) return;
  // one that dies is named with its death; for a while: a device may keep it from ending
  if (const Child* const child = watched_.group.find(name); child != nullptr && child->is_dying()) {
    if (!dying_since_) dying_since_ = now;
    if (now - *dying_since_ < kLongestDeath) return;
  }
  fail(process::ExitCode::system,
       fmt::format("process {} is silent for {} s", name, watched_.deployment.heartbeat_timeout));
}

void Supervisor::check_clock() {
  if (!ending_ && watched_.clock.state() == clock::State::failed)
    fail(process::ExitCode::system, "clock lost: " + watched_.clock.error());
}

void Supervisor::fail(process::ExitCode code, std::string reason) {
  if (result_.code != process::ExitCode::success) return;  // it is a consequence of the first failure
  watched_.faults.tell();
  ending_ = true;
  result_.code = code;
  result_.reason = std::move(reason);
  watched_.progress.error("mrroc: " + watched_.deployment.name + ": " + result_.reason);
}

void Supervisor::watch_operator(int milliseconds) {
  ending_ = true;
  pollfd signal{signals_.descriptor(), POLLIN, 0};
  poll(&signal, 1, milliseconds);
  read_signals();
  watched_.progress.draw();
}

void Supervisor::turn_at_the_end() {
  guard([this] { turn(kTurn); });
}

}  // namespace mrroc::cli
