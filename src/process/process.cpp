#include "process/process.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <new>
#include <system_error>

#include "clock/participant.hpp"
#include "clock/wall/realtime.hpp"
#include "config/table.hpp"
#include "mrroc/stopped.hpp"
#include "process/record/text_memory.hpp"
#include "process/signals/end_request.hpp"

namespace mrroc::process {

namespace {

links::ProcessStatus first_status(const Arguments& arguments, links::ProcessRole role) {
  links::ProcessStatus status;
  status.process.assign(arguments.name);
  status.role = role;
  status.state = links::ProcessState::starting;
  status.pid = getpid();
  return status;
}

/// The original's order: processes closer to the drives first.
int priority_of(links::ProcessRole role) {
  switch (role) {
    case links::ProcessRole::edp:
      return 80;
    case links::ProcessRole::sim:
      return 75;
    case links::ProcessRole::vsp:
      return 70;
    case links::ProcessRole::ecp:
      return 60;
    case links::ProcessRole::mp:
      return 50;
  }
  return 50;
}

/// Under simulated time the runner watches the processes: a busy machine must not count as a death.
links::DomainOptions domain_options(const Arguments& arguments, bool simulated, double heartbeat_timeout) {
  links::DomainOptions options;
  options.id = arguments.domain;
  options.interface = arguments.interface;
  options.hosts = arguments.peers;
  options.keys = arguments.keys;
  options.lease = simulated ? 0 : heartbeat_timeout;
  return options;
}

/// An exception that is not an `Error`: the system's, or one that a task throws.
ErrorCode code_of_foreign(const std::exception& error) noexcept {
  if (dynamic_cast<const config::ConfigurationError*>(&error) != nullptr) return ErrorCode::configuration;
  const bool system = dynamic_cast<const std::system_error*>(&error) != nullptr ||
                      dynamic_cast<const std::bad_alloc*>(&error) != nullptr;
  return system ? ErrorCode::resources : ErrorCode::task_failed;
}

clock::Part part_of(links::ProcessRole role) {
  if (role == links::ProcessRole::sim) return clock::Part::world;
  return role == links::ProcessRole::edp ? clock::Part::drives : clock::Part::task;
}

/// Only this process uses the inherited descriptors: programs that a task starts must hold neither clock nor world.
void keep_from_children(int fd) { fcntl(fd, F_SETFD, FD_CLOEXEC); }

/// From the text that the runner passes: the file may have changed since, or be readable only for the runner.
config::Deployment load(const Arguments& arguments) {
  if (arguments.deployment_fd < 0) return config::load_deployment(arguments.deployment);
  return config::load_deployment(arguments.deployment, read_text(arguments.deployment_fd));
}

bool serves(links::ProcessRole role) {
  return role == links::ProcessRole::edp || role == links::ProcessRole::vsp || role == links::ProcessRole::sim;
}

}  // namespace

Process::Process(const Arguments& arguments, links::ProcessRole role)
    : arguments_(arguments), deployment_(load(arguments)), faults_(arguments.faults) {
  for (const int fd : arguments.descriptors()) keep_from_children(fd);
  clock_ = clock::attach_clock(arguments.clock_fd, arguments.name, part_of(role));
  if (role == links::ProcessRole::mp) {
    auto fibers = std::make_unique<FiberScheduler>(std::move(clock_));
    fibers_ = fibers.get();
    clock_ = std::move(fibers);
  }
  interrupt_at_request(clock_.get());
  // before the domain: Cyclone's threads inherit the priority of the thread that creates them
  // what is refused the runner has said once for all processes of the machine, an agent for those of its own
  if (!clock_->simulated()) clock::request_realtime(priority_of(role));
  domain_ =
      std::make_unique<links::Domain>(domain_options(arguments, clock_->simulated(), deployment_.heartbeat_timeout));
  publisher_ = std::make_unique<links::StatusPublisher>(*domain_, deployment_.name);
  links::ProcessStatus status = first_status(arguments, role);
  status.boot = domain_->boot();
  status_ = std::make_unique<StatusBoard>(*publisher_, status, *clock_);
}

Process::~Process() { interrupt_at_request(nullptr); }

void Process::fail_at_end(std::string reason) {
  if (failure_at_end_.empty()) failure_at_end_ = std::move(reason);
}

void Process::start() {
  status_->state(links::ProcessState::ready);
  const bool started = clock_->start();
  set_up_ends();
  if (!started) throw Stopped{};
  started_ = true;
  status_->state(links::ProcessState::running);
}

ErrorReport report_of(const std::exception& error) noexcept {
  ErrorReport report;
  if (const auto* known = dynamic_cast<const Error*>(&error)) {
    report.error_class = known->error_class();
    report.code = known->code();
    report.detail.assign(known->detail());
    return report;
  }
  report.error_class = ErrorClass::system;
  report.code = code_of_foreign(error);
  report.detail.assign(error.what());
  return report;
}

ExitCode exit_code(const std::exception& error) noexcept {
  if (dynamic_cast<const config::ConfigurationError*>(&error) != nullptr) return ExitCode::usage;
  return exit_code(report_of(error).error_class);
}

namespace {

/// Of an exception that ends the process; null: it was not set up.
ExitCode code_of(const std::exception& error, const Process* process) noexcept {
  if (process == nullptr) return ExitCode::usage;
  const ErrorReport report = report_of(error);
  const bool refused = report.error_class == ErrorClass::system && report.code == ErrorCode::configuration;
  return refused && !process->started() ? ExitCode::usage : exit_code(error);
}

/// The end of a successful body; returns the exit code of the process. Null: it was not set up.
int end(Process* process, ExitCode code, bool report = true) {
  if (process == nullptr) return static_cast<int>(code);
  if (report) process->status().state(links::ProcessState::ended);
  if (process->failure_at_end().empty()) return static_cast<int>(code);
  std::fprintf(stderr, "%s\n", process->failure_at_end().c_str());
  return static_cast<int>(ExitCode::system);
}

}  // namespace

int run_process(int argc, char** argv, links::ProcessRole role, const std::function<void(Process&)>& body) {
  std::unique_ptr<Process> process;
  receive_end_requests();
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);  // a pipe's buffer would hold a task's output until it ends
  try {
    const std::optional<Arguments> arguments = parse_arguments(argc, argv);
    if (!arguments) return static_cast<int>(ExitCode::success);
    process = std::make_unique<Process>(*arguments, role);
    body(*process);
    return end(process.get(), ExitCode::success);
  } catch (const Stopped&) {
    return end(process.get(), serves(role) ? ExitCode::success : ExitCode::stopped);
  } catch (const std::exception& error) {
    // when all processes should end, some lose their peers: that is not their own failure
    if (asked_to_end()) return end(process.get(), ExitCode::stopped, false);
    std::fprintf(stderr, "%s\n", error.what());
    if (process) process->status().failed(report_of(error));
    return static_cast<int>(code_of(error, process.get()));
  }
}

}  // namespace mrroc::process
