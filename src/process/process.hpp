#pragma once

#include <functional>
#include <memory>
#include <string>

#include "clock/clock.hpp"
#include "config/deployment.hpp"
#include "faults/fault_plan.hpp"
#include "links/transport/domain.hpp"
#include "process/arguments.hpp"
#include "process/exit_code.hpp"
#include "process/fibers.hpp"
#include "process/status_board.hpp"

namespace mrroc::process {

/// Common parts of every process of a deployment: the deployment file, its clock, its DDS domain, its status. Built by
/// `run_process`. Main thread.
class Process {
 public:
  Process(const Arguments& arguments, links::ProcessRole role);
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  const std::string& name() const noexcept { return arguments_.name; }
  const Arguments& arguments() const noexcept { return arguments_; }
  const config::Deployment& deployment() const noexcept { return deployment_; }
  clock::Clock& clock() noexcept { return *clock_; }
  /// The same, where the task may run fibers: in an MP. Null in all others.
  FiberScheduler* fibers() noexcept { return fibers_; }
  links::Domain& domain() noexcept { return *domain_; }
  StatusBoard& status() noexcept { return *status_; }
  /// The faults to be injected into this run; usually empty.
  const faults::FaultPlan& faults() const noexcept { return faults_; }
  /// "<deployment>/<path>", the common beginning of topic names.
  std::string topic(const std::string& path) const { return deployment_.name + "/" + path; }

  /// Sets a failure of this process although its body succeeds: an incomplete output. The first reason counts; it is
  /// reported when the body has ended.
  void fail_at_end(std::string reason);
  const std::string& failure_at_end() const noexcept { return failure_at_end_; }

  /// The start-up barrier: reports ready and waits until every process of the deployment is ready. Throws Stopped when
  /// the process should end.
  void start();
  /// The barrier has been passed: what was wrong in the deployment has been refused before.
  bool started() const noexcept { return started_; }

 private:
  Arguments arguments_;
  config::Deployment deployment_;
  faults::FaultPlan faults_;
  std::unique_ptr<clock::Clock> clock_;
  FiberScheduler* fibers_ = nullptr;
  std::unique_ptr<links::Domain> domain_;
  std::unique_ptr<links::StatusPublisher> publisher_;
  std::unique_ptr<StatusBoard> status_;
  std::string failure_at_end_;
  bool started_ = false;
};

/// main() of every process: reads the arguments, installs signal handlers (SIGTERM, SIGINT: the clock is interrupted),
/// builds the Process, runs `body`, reports its exception to the operator and on stderr, and returns the exit code. A
/// SystemError(configuration) before the start is the deployment's: usage, as for a ConfigurationError.
/// `Stopped` is success for processes that serve (edp, vsp, sim) and ExitCode::stopped for tasks.
int run_process(int argc, char** argv, links::ProcessRole role, const std::function<void(Process&)>& body);

/// An exception as an error for messages. Not `Error`: class system, code configuration, resources (of the operating
/// system) or task_failed, with its `what()`.
ErrorReport report_of(const std::exception& error) noexcept;

/// The exit code for an exception that ends a process: usage for a ConfigurationError, in a file that the user can
/// repair, else by class.
ExitCode exit_code(const std::exception& error) noexcept;

}  // namespace mrroc::process
