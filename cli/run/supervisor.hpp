#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cli/hosts/remote_hosts.hpp"
#include "cli/operator/operator_service.hpp"
#include "cli/operator/socket/operator_socket.hpp"
#include "cli/operator/terminal/operator_console.hpp"
#include "cli/output/black_boxes.hpp"
#include "cli/processes/process_group.hpp"
#include "cli/processes/process_plan.hpp"
#include "cli/processes/signals.hpp"
#include "cli/run/fault_injector.hpp"
#include "cli/run/progress.hpp"
#include "cli/run/run_links.hpp"
#include "cli/run/run_result.hpp"
#include "cli/run/side_process.hpp"
#include "cli/run/watch/heartbeats.hpp"
#include "cli/run/watch/stall_watch.hpp"
#include "clock/host.hpp"
#include "config/deployment.hpp"
#include "process/exit_code.hpp"

namespace mrroc::cli {

/// The objects that a supervisor watches and reports to; all outlive it.
struct Watched {
  const config::Deployment& deployment;
  const std::vector<PlannedProcess>& plan;
  clock::ClockHost& clock;
  const clock::Clock& wall;  ///< the operator's
  ProcessGroup& group;
  FaultInjector& faults;
  BlackBoxes& black_boxes;
  Progress& progress;
  OperatorService& service;
};

/// Finds the one reason why a run ends. It receives the operator's signals, the deaths and silences of processes, here
/// and on other hosts, the state of the clock and of the task, checks causes before their consequences, and shows the
/// progress. Before the first turn it blocks the signals that it takes (see Signals). Main thread.
class Supervisor {
 public:
  static constexpr int kTurn = 20;  ///< ms between checks of the links

  explicit Supervisor(const Watched& watched);

  /// From now on these are watched, too; they outlive the supervisor's last turn.
  void watch(RemoteHosts& hosts) { hosts_ = &hosts; }
  void watch(RunLinks& links, OperatorConsole& console) {
    links_ = &links;
    console_ = &console;
  }
  void watch(OperatorSocket& socket) { socket_ = &socket; }
  void watch(SideProcess& side) { sides_.push_back(&side); }
  /// The processes that have not reported any status yet.
  std::vector<std::string> without_status() const { return heartbeats_.missing(names_of(watched_.plan)); }
  /// All processes are ready and the clock starts: from now on each must send heartbeats.
  void task_starts();
  bool task_started() const noexcept { return task_started_; }
  /// The processes begin to end: the task's length is known.
  void task_ends();
  /// How the run has ended, with the last statuses of its processes.
  RunResult result() const;

  /// One turn: waits at most `milliseconds` for signals and output; true when all is well.
  bool turn(int milliseconds);
  /// Turns until the run has to end.
  void supervise();
  /// A turn while processes end, which nothing may prevent.
  void turn_at_the_end();
  /// Waits at most `milliseconds` for the operator's signals, when all processes have ended, and writes the display.
  void watch_operator(int milliseconds);
  /// Takes a step; its exception becomes the reason of the failure.
  void guard(const std::function<void()>& step);

  /// The operator has requested the end.
  bool interrupted() const noexcept { return interrupts_ > 0 || hurried_; }
  /// The operator has requested the end again while the run was ending: no optional wait follows.
  bool hurried() const noexcept { return hurried_; }
  /// The task has ended or failed: processes may end.
  bool ending() const noexcept { return ending_; }
  /// Sets the reason of the failure; ignores later reasons, which are consequences.
  void fail(process::ExitCode code, std::string reason);
  /// The same when a process is lost. `exit_code` -1: a signal has ended it.
  void process_lost(const std::string& name, int exit_code, const std::string& how);

 private:
  void read_signals();
  void interrupt_by_operator();
  void read_statuses();
  void read_task_status();
  void take(const links::TaskStatus& status);
  /// The task reports that a process has died or is cut off: searches briefly for the process and the cause.
  void await_cause();
  /// A process that finds the runner stopped by a signal begins the end; otherwise the runner does.
  void check_stop();
  void check_children();
  void check_heartbeats();
  void check_clock();
  void wait(int milliseconds);
  /// The operator's typed lines and requests of the socket.
  void poll_operator();
  void publish_telemetry();
  process::ExitCode code_of_death(int exit_code) const;
  int descriptor() { return hosts_ ? hosts_->descriptor(signals_.descriptor()) : signals_.descriptor(); }

  const Watched watched_;
  Signals signals_;
  Heartbeats heartbeats_;
  std::optional<double> dying_since_;  ///< s: a silent process has been ending since then
  StallWatch stall_;
  RemoteHosts* hosts_ = nullptr;
  RunLinks* links_ = nullptr;
  OperatorConsole* console_ = nullptr;
  OperatorSocket* socket_ = nullptr;
  std::vector<SideProcess*> sides_;
  int interrupts_ = 0;
  bool ending_ = false;
  bool hurried_ = false;
  bool task_started_ = false;
  double started_at_ = 0;  // s of wall time
  double next_telemetry_ = 0;
  RunResult result_;
};

}  // namespace mrroc::cli
