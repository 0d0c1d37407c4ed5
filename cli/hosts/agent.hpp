#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/hosts/agent_protocol.hpp"
#include "cli/hosts/host_link.hpp"
#include "cli/hosts/line_channel.hpp"
#include "cli/operator/task_records.hpp"
#include "cli/processes/process_group.hpp"
#include "cli/processes/process_plan.hpp"
#include "cli/processes/signals.hpp"
#include "cli/run/domain_lock.hpp"
#include "clock/host.hpp"
#include "process/exit_code.hpp"
#include "process/record/claimed_file.hpp"
#include "world/mapped_world.hpp"

namespace mrroc::cli {

/// `mrroc agent`: the process that `mrroc run` starts on every other host of a deployment, with a control channel on
/// stdin and stdout (agent_protocol.hpp). It starts the processes of that host under their own clock, whose tick 0 is
/// the runner's, and forwards their output. It stops them, robots first, when it is instructed to, when one of them
/// dies, when the channel closes, when the runner's beats stop, and when the runner never sends "start": no robot
/// continues without its runner. Main thread.
class Agent {
 public:
  /// Timeout for the order, s.
  static constexpr double kPatienceWithOrder = 30;

  /// Takes both descriptors.
  Agent(int in, int out, double patience_with_order = kPatienceWithOrder);
  ~Agent();
  process::ExitCode run();

 private:
  /// Returns false when the runner is gone before it has sent its order. Throws std::runtime_error when the order does
  /// not arrive in time.
  bool take_order();
  void prepare();
  void start_processes();
  void supervise();
  void end_processes();
  void turn_at_the_end();
  void send_steps();
  /// Gives the runner time to take the waiting lines.
  void drain();

  void turn(int milliseconds);
  void obey(const std::string& line);
  void read_signals();
  void report_missing();
  void check_children();
  void fail(process::ExitCode code, const std::string& reason);

  const double patience_with_order_;  // s
  LineChannel runner_;
  Signals signals_;
  int wake_ = -1;  // epoll: the channel, signals, the link
  AgentOrder order_;
  config::Deployment deployment_;
  std::vector<PlannedProcess> plan_;
  std::unique_ptr<DomainLock> domain_lock_;
  std::unique_ptr<clock::ClockHost> clock_;
  std::unique_ptr<clock::Clock> operator_clock_;
  std::unique_ptr<world::MappedWorld> world_;
  std::unique_ptr<HostLink> link_;
  std::string own_address_;
  std::unique_ptr<TaskRecords> records_;
  std::optional<process::ClaimedFile> motion_;  // of the simulator on this host
  ProcessGroup group_;
  std::string missing_ = "?";  // as reported last
  bool started_ = false;
  bool stopping_ = false;
  process::ExitCode code_ = process::ExitCode::success;
};

}  // namespace mrroc::cli
