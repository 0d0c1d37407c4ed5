#include <utility>

#include "mrroc/mp.hpp"
#include "mrroc/stopped.hpp"
#include "process/build_scope.hpp"
#include "process/standard_files.hpp"

namespace mrroc::mp {

Task::Task() : TaskProcess(process::BuildScope::process(), process::BuildScope::process().topic("mp")) {
  for (const config::RobotEntry& robot : process().deployment().robots) {
    ecps_[robot.name].link = std::make_unique<links::TaskSuperior>(process().domain(), process().clock(),
                                                                   process().topic(robot.name), robot.name);
  }
}

std::string Task::robot_name(const std::string& requested) const {
  if (!requested.empty()) return requested;
  throw NonFatalError(ErrorCode::invalid_argument, "a robot of an MP task needs its name", {process_name(), "", 0, 0});
}

std::string Task::robot_topic(const std::string& name) const { return process().topic(name + "/mp"); }

void Task::connect() {
  connect_links();
  for (auto& [name, ecp] : ecps_) ecp.link->connect(process().deployment().start_timeout);
}

Task::Ecp& Task::ecp(const std::string& name, const char* asked) {
  const auto found = ecps_.find(name);
  if (found != ecps_.end()) return found->second;
  throw NonFatalError(ErrorCode::invalid_argument, std::string(asked) + ": the deployment has no robot '" + name + "'",
                      {process_name(), name, 0, 0});
}

void Task::start_with(const std::string& name, const Message& behaviour) {
  Ecp& started = ecp(name, "start");
  wait_until([] { return true; });  // not while paused
  if (started.running) {
    throw NonFatalError(ErrorCode::busy, "start: the ECP of robot '" + name + "' still runs its previous start",
                        {process_name(), name, 0, tick()});
  }
  started.running = true;
  started.asked_to_stop = false;
  started.status = links::TaskStatus{};
  started.mailbox.clear();
  started.started_by = started.link->send(links::TaskCommandKind::start, behaviour);
}

bool Task::running(const std::string& name) {
  poll_others();
  return ecp(name, "running").running;
}

void Task::end_motion(const std::string& name) {
  Ecp& ended = ecp(name, "end_motion");
  poll_others();
  if (ended.running) ended.link->send(links::TaskCommandKind::end_motion);
}

void Task::stop(const std::string& name) {
  Ecp& stopped = ecp(name, "stop");
  poll_others();
  if (stopped.running) {
    stopped.asked_to_stop = true;
    stopped.link->send(links::TaskCommandKind::stop);
  }
  for (;;) {  // check before waiting: a message that has already arrived causes no wake-up
    read_superior();
    poll_others();
    if (!stopped.running) break;
    if (process().clock().wait(kNever) == clock::Wake::interrupted) throw Stopped{};
  }
  if (stopped_) throw Stopped{};
  if (stopped.status.state == links::TaskState::failed) rethrow(stopped);
}

void Task::start_all() {
  for (const auto& entry : ecps_) start(entry.first);
}

void Task::wait_for_all() {
  wait_for_running();
  if (Ecp* ecp = failed()) {
    command_running(links::TaskCommandKind::stop);
    while (any_running()) wait_for_running();
    const links::TaskStatus first = ecp->status;
    for (auto& [name, other] : ecps_) other.status = links::TaskStatus{};  // not reported again
    ecp->status = first;
    rethrow(*ecp);
  }
  if (stopped_) throw Stopped{};
}

void Task::wait_for_all(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    const Ecp& awaited = ecp(name, "wait_for_all");
    wait_until([&awaited] { return !awaited.running; });
  }
}

std::string Task::wait_for_any(const std::vector<std::string>& names) {
  if (names.empty())
    throw NonFatalError(ErrorCode::invalid_argument, "wait_for_any: no robots", {process_name(), "", 0, 0});
  std::string ended;
  wait_until([&] {
    for (const std::string& name : names) {
      if (ecp(name, "wait_for_any").running) continue;
      ended = name;
      return true;
    }
    return false;
  });
  return ended;
}

void Task::tell_parcel(const std::string& name, const Message& parcel) {
  ecp(name, "tell").link->send(links::TaskCommandKind::message, parcel);
}

bool Task::take_parcel(const std::string& name, std::string_view label, Message& parcel) {
  poll_others();
  return ecp(name, "take").mailbox.take(label, parcel);
}

void Task::forget_messages(const std::string& name) { ecp(name, "forget_messages").mailbox.clear(); }

bool Task::heard_label(const std::string& name, std::string_view label) {
  poll_others();
  return ecp(name, "heard").mailbox.has(label);
}

void Task::concurrently(const std::vector<std::function<void()>>& parts) { process().fibers()->run(parts); }

OperatorRequest Task::operator_request() {
  const OperatorRequest request = TaskProcess::operator_request();
  if (Ecp* ecp = failed()) rethrow(*ecp);
  return request;
}

/// Throws the error with which the ECP has failed; from now on it counts as reported.
void Task::rethrow(Ecp& failed) {
  const links::TaskStatus status = std::exchange(failed.status, links::TaskStatus{});
  const ErrorOrigin origin{std::string{status.process.view()}, std::string{status.device.view()}, status.step,
                           status.error_tick};
  throw_error(status.error.error_class, status.error.code, std::string{status.error.detail.view()}, origin);
}

void Task::wait_for_running() {
  for (;;) {
    read_superior();
    const bool had_failed = failed() != nullptr;
    poll_others();
    if (!any_running() || (!had_failed && failed() != nullptr)) return;
    if (process().fibers()->cancelled()) throw Stopped{};
    if (process().clock().wait(kNever) == clock::Wake::interrupted) throw Stopped{};
  }
}

void Task::poll_others() {
  for (auto& [name, ecp] : ecps_) {
    links::TaskStatus status;
    std::uint64_t last_command = 0;
    while (ecp.link->take(status, last_command)) {
      if (last_command < ecp.started_by) continue;  // from before this start
      if (!status.parcel.label.empty()) {
        ecp.mailbox.put(status.parcel);
        continue;
      }
      note(name, ecp, status);
    }
  }
}

void Task::note(const std::string& name, Ecp& ecp, links::TaskStatus status) {
  if (status.state == links::TaskState::stopped && !ecp.asked_to_stop) {
    status.state = links::TaskState::failed;
    status.error = {ErrorClass::system, ErrorCode::process_died, std::string_view{"it was ended from outside"}};
    status.process.assign(name);
    status.error_tick = status.tick;
  }
  ecp.status = status;
  if (status.state != links::TaskState::running && status.state != links::TaskState::paused) ecp.running = false;
}

void Task::on_superior_command(const links::TaskCommand& command) {
  if (command.kind == links::TaskCommandKind::start) return;
  if (command.kind == links::TaskCommandKind::speed) {
    for (auto& [name, ecp] : ecps_) ecp.link->send_speed(operator_speed());  // those that start later, too
    return;
  }
  if (command.kind == links::TaskCommandKind::stop) stopped_ = true;
  command_running(command.kind);
}

void Task::command_running(links::TaskCommandKind kind) {
  for (auto& [name, ecp] : ecps_) {
    if (!ecp.running) continue;
    if (kind == links::TaskCommandKind::stop) ecp.asked_to_stop = true;
    ecp.link->send(kind);
  }
}

bool Task::any_running() const noexcept {
  for (const auto& [name, ecp] : ecps_) {
    if (ecp.running) return true;
  }
  return false;
}

Task::Ecp* Task::failed() noexcept {
  for (auto& [name, ecp] : ecps_) {
    if (!ecp.running && ecp.status.state == links::TaskState::failed) return &ecp;
  }
  return nullptr;
}

namespace {

void serve(process::Process& process, const TaskFactory& factory) {
  const process::BuildScope scope(process);
  const std::unique_ptr<Task> task = factory();
  task->connect();
  process.start();
  while (!task->read_superior()) {
    if (process.clock().wait(kNever) == clock::Wake::interrupted) throw Stopped{};
  }
  task->report(links::TaskState::running);
  try {
    task->await_published_sensors();
    task->run();
    task->report(links::TaskState::succeeded);
  } catch (const Stopped&) {
    task->report(links::TaskState::stopped);
  } catch (const std::exception& error) {
    task->report_failure(error);
  }
  process.clock().end_task();
  // the operator ends the deployment when it has seen the result
  while (process.clock().wait(kNever) != clock::Wake::interrupted) {
  }
}

}  // namespace

int run(int argc, char** argv, const TaskFactory& factory) {
  process::open_standard_files();
  return process::run_process(argc, argv, links::ProcessRole::mp,
                              [&factory](process::Process& process) { serve(process, factory); });
}

}  // namespace mrroc::mp
