#include <cstdio>
#include <string_view>

#include "ecp/superior_commands.hpp"
#include "mrroc/ecp.hpp"
#include "mrroc/stopped.hpp"
#include "process/build_scope.hpp"
#include "process/standard_files.hpp"

namespace mrroc::ecp {

Task::Task()
    : TaskProcess(process::BuildScope::process(),
                  process::BuildScope::process().topic(process::BuildScope::process().name())),
      mp_(process().domain(), process().clock(), process().topic(process().name() + "/mp"),
          process().deployment().heartbeat_timeout),
      edp_(&robot_link(process().name(), process().deployment().robot(process().name()).type)),
      requester_(dynamic_cast<links::RobotRequester*>(edp_)),
      superior_commands_(std::make_unique<SuperiorCommands>(process(), mp_)),
      superior_(*superior_commands_) {}

Task::~Task() = default;

std::string Task::robot_name(const std::string& requested) const {
  if (requested.empty() || requested == process_name()) return process_name();
  throw NonFatalError(ErrorCode::invalid_argument,
                      "robot '" + requested + "' in the ECP of '" + process_name() + "': an ECP has its own robot only",
                      {process_name(), requested, 0, 0});
}

std::string Task::robot_topic(const std::string& name) const { return process().topic(name); }

std::string Task::robot_peer(const std::string& name) const { return process().deployment().robot(name).edp_process(); }

void Task::run_started() try {
  if (started().label.empty())
    run();
  else
    behaviours_.run(started());
} catch (const SystemError&) {
  throw;  // there may be no caller to answer
} catch (...) {
  come_to_rest();
  throw;
}

void Task::come_to_rest() {
  command_ = RobotCommand{};
  command_.kind = CommandKind::hold;
  do {
    edp_->send(command_);
    edp_->receive(state_);
  } while (state_.error.error_class == ErrorClass::none && !state_.at_rest());
}

void Task::tell_parcel(const Message& parcel) {
  links::TaskStatus status;
  status.state = links::TaskState::running;
  status.tick = tick();
  status.parcel = parcel;
  task_link().report(status);
}

void Task::relay() {
  std::uint64_t sequence = 0;
  while (mp_.take(command_, sequence)) {
    if (command_.kind == CommandKind::end) {  // of a Move that this ECP has left
      mp_.reply(state_, sequence);
      continue;
    }
    if (requester_ != nullptr) {
      requester_->forward(mp_, command_);
      requester_->receive(state_);
      mp_.forward(*requester_, sequence);
    } else {
      edp_->send(command_);
      edp_->receive(state_);
      mp_.reply(state_, sequence);
    }
  }
}

void Task::poll_others() {
  if (superior_commands_->joined()) return;
  std::uint64_t sequence = 0;
  while (mp_.take(command_, sequence)) {
    state_ = RobotState{};
    state_.tick = state_.desired_tick = tick();
    state_.error.error_class = ErrorClass::non_fatal;
    state_.error.code = ErrorCode::busy;
    state_.error.detail.assign("the ECP runs its own task");
    mp_.reply(state_, sequence);
  }
}

namespace {

/// Runs the task once and reports how it ended to the MP.
void run_task(Task& task) {
  task.report(links::TaskState::running);
  try {
    task.await_published_sensors();
    task.run_started();
    task.report(links::TaskState::succeeded);
  } catch (const Stopped&) {
    task.report(links::TaskState::stopped);
  } catch (const std::exception& error) {
    task.report_failure(error);
  }
}

void serve(process::Process& process, const TaskFactory& factory) {
  const process::BuildScope scope(process);
  const std::unique_ptr<Task> task = factory();
  task->connect_links();
  process.start();
  for (;;) {
    if (task->read_superior()) run_task(*task);
    task->relay();
    if (process.clock().wait(kNever) == clock::Wake::interrupted) throw Stopped{};
  }
}

}  // namespace

int run(int argc, char** argv, const TaskFactory& factory) {
  process::open_standard_files();
  if (argc == 2 && std::string_view{argv[1]} == "--behaviours") {  // to check state machines
    return std::fputs(config::to_text(Behaviours::declared()).c_str(), stdout) >= 0 && std::fflush(stdout) == 0 ? 0 : 4;
  }
  return process::run_process(argc, argv, links::ProcessRole::ecp,
                              [&factory](process::Process& process) { serve(process, factory); });
}

}  // namespace mrroc::ecp
