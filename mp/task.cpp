#include "mrroc/mp.hpp"
#include "mrroc/stopped.hpp"
#include "process/build_scope.hpp"

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

void Task::start(const std::string& name) {
  const auto found = ecps_.find(name);
  if (found == ecps_.end()) {
    throw NonFatalError(ErrorCode::invalid_argument, "start: the deployment has no robot '" + name + "'",
                        {process_name(), name, 0, 0});
  }
  found->second.running = true;
  found->second.status = links::TaskStatus{};
  found->second.started_by = found->second.link->send(links::TaskCommandKind::start);
}

void Task::start_all() {
  for (const auto& entry : ecps_) start(entry.first);
}

void Task::wait_for_all() {
  wait_for_running();
  if (const Ecp* ecp = failed()) {
    command_running(links::TaskCommandKind::stop);
    const links::TaskStatus status = ecp->status;
    while (any_running()) wait_for_running();
    throw_error(status.error.error_class, status.error.code, std::string{status.error.detail.view()},
                {std::string{status.process.view()}, "", status.step, status.tick});
  }
  if (stopped_) throw Stopped{};
}

void Task::wait_for_running() {
  for (;;) {
    read_superior();
    const bool had_failed = failed() != nullptr;
    poll_others();
    if (!any_running() || (!had_failed && failed() != nullptr)) return;
    if (process().clock().wait(kNever) == clock::Wake::interrupted) throw Stopped{};
  }
}

void Task::poll_others() {
  for (auto& [name, ecp] : ecps_) {
    links::TaskStatus status;
    std::uint64_t last_command = 0;
    while (ecp.link->take(status, last_command)) {
      if (last_command < ecp.started_by) continue;  // from before this start
      ecp.status = status;
      if (status.state != links::TaskState::running && status.state != links::TaskState::paused) ecp.running = false;
    }
  }
}

void Task::on_superior_command(const links::TaskCommand& command) {
  if (command.kind == links::TaskCommandKind::start) return;
  if (command.kind == links::TaskCommandKind::stop) stopped_ = true;
  command_running(command.kind);
}

void Task::command_running(links::TaskCommandKind kind) {
  for (auto& [name, ecp] : ecps_) {
    if (ecp.running) ecp.link->send(kind);
  }
}

bool Task::any_running() const noexcept {
  for (const auto& [name, ecp] : ecps_) {
    if (ecp.running) return true;
  }
  return false;
}

const Task::Ecp* Task::failed() const noexcept {
  for (const auto& [name, ecp] : ecps_) {
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
    task->run();
    task->report(links::TaskState::succeeded);
  } catch (const Stopped&) {
    task->report(links::TaskState::stopped);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    task->report(links::TaskState::failed, process::report_of(error));
  }
  // the operator ends the deployment when it has seen the result
  while (process.clock().wait(kNever) != clock::Wake::interrupted) {
  }
}

}  // namespace

int run(int argc, char** argv, const TaskFactory& factory) {
  return process::run_process(argc, argv, links::ProcessRole::mp,
                              [&factory](process::Process& process) { serve(process, factory); });
}

}  // namespace mrroc::mp
