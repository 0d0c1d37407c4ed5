#pragma once

#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "cli/black_boxes.hpp"
#include "cli/crew.hpp"
#include "cli/domain_lock.hpp"
#include "cli/fault_injector.hpp"
#include "cli/heartbeats.hpp"
#include "cli/operator_desk.hpp"
#include "cli/process_plan.hpp"
#include "cli/progress.hpp"
#include "cli/remote_hosts.hpp"
#include "cli/run_options.hpp"
#include "cli/run_result.hpp"
#include "cli/stall_watch.hpp"
#include "cli/task_commands.hpp"
#include "cli/trace_parts.hpp"
#include "cli/typed_lines.hpp"
#include "clock/host.hpp"
#include "config/deployment.hpp"
#include "links/domain.hpp"
#include "links/status_collector.hpp"
#include "links/task_superior.hpp"
#include "process/exit_code.hpp"
#include "sim/mapped_world.hpp"

namespace mrroc::cli {

/// `mrroc run`: starts every process of a deployment, opens the clock when all are ready, starts the MP, shows
/// progress, forwards Ctrl-C and the operator's answers, notices a process that dies or is silent, and ends every
/// process whatever happens. Main thread.
class Runner {
 public:
  Runner(const config::Deployment& deployment, RunOptions options);
  ~Runner();
  /// The outcome of the task, whatever becomes of what is said about it.
  process::ExitCode run();

 private:
  /// Takes a step; what it throws is why the run fails.
  void guard(const std::function<void()>& step);
  void start_processes(const TraceParts& trace);
  void pass_barrier();
  /// Shakes hands with the MP, and sees meanwhile who dies and what the operator wants; false when all is to end.
  bool connect_to_mp(double deadline);
  /// This process's own part in the deployment's communication.
  void open_links(const links::DomainOptions& options);
  void supervise();
  void end_processes();

  /// One turn of the supervisor: waits at most `milliseconds` for signals and output; true when all is well.
  bool turn(int milliseconds);
  /// The same while processes end, from which nothing may keep them.
  void turn_at_the_end();
  void read_signals();
  void read_statuses();
  void read_task_status();
  /// The task says that a process has died or is cut off: looks for a moment which one, and why.
  void await_cause();
  /// Who finds the runner stopped by a signal begins the end of all, which is else the runner's to begin.
  void check_stop();
  void check_children();
  /// `exit_code` -1: a signal has ended it.
  void process_lost(const std::string& name, int exit_code, const std::string& how);
  process::ExitCode code_of_death(int exit_code) const;
  /// What is done when another host reports something.
  HostListener host_listener(const TraceParts& trace);
  /// What all other hosts are told alike.
  AgentOrder common_order() const;
  /// The processes here, and what the other hosts wait for.
  std::vector<std::string> not_ready();
  void end_hosts();
  void check_heartbeats();
  void check_clock();
  void look_at_desk();
  void interrupt_by_operator();
  void fail(process::ExitCode code, std::string reason);

  config::Deployment deployment_;
  RunOptions options_;
  std::vector<PlannedProcess> plan_;
  BlackBoxes black_boxes_;
  Progress progress_;
  DomainLock domain_lock_;
  clock::ClockHost clock_;
  std::unique_ptr<clock::Clock> operator_clock_;
  std::unique_ptr<sim::MappedWorld> world_;
  int signals_ = -1;
  Crew crew_;
  std::map<std::string, std::ofstream> remote_traces_;  // parts that come from other hosts
  std::unique_ptr<RemoteHosts> hosts_;
  FaultInjector faults_;
  std::unique_ptr<links::Domain> domain_;
  std::unique_ptr<links::StatusCollector> collector_;
  std::unique_ptr<links::TaskSuperior> mp_;
  TypedLines input_;
  std::unique_ptr<OperatorDesk> desk_;
  std::unique_ptr<TaskCommands> commands_;

  Heartbeats heartbeats_;
  StallWatch stall_;
  int interrupts_ = 0;
  bool stopping_ = false;  // the task has ended or failed: processes may go
  bool task_started_ = false;
  RunResult result_;
};

}  // namespace mrroc::cli
