#pragma once

#include <signal.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "cli/hosts/agent_protocol.hpp"
#include "cli/hosts/host_link.hpp"
#include "cli/hosts/line_channel.hpp"
#include "cli/processes/child.hpp"
#include "process/exit_code.hpp"

namespace mrroc::cli {

/// The runner's callbacks for events of its other hosts. Called in the main thread.
struct HostListener {
  std::function<void(const std::string& line)> message;  ///< for the operator
  /// A process has ended or was stopped, `how` describes it; `exit_code` -1: by a signal.
  std::function<void(const std::string& process, int exit_code, const std::string& how)> lost;
  std::function<void(process::ExitCode code, const std::string& reason)> failed;
  std::function<void(const std::string& process, recording::RecordedStep step)> step;  ///< to be recorded
  std::function<void(const std::string& process, const recording::StepCounts& counts)> steps_end;
  /// One of its last steps, the oldest first (process::SharedBlackBox).
  std::function<void(const std::string& process, recording::RecordedStep step)> last_step;
};

/// Limits of the deployment, s.
struct HostLimits {
  double link_timeout = 0.04;
  double clock_error = 0.001;
};

/// The words that start `mrroc agent` on a host: its command, or ssh, which passes its words to a shell there.
std::vector<std::string> agent_command(const config::HostEntry& host);

/// The runner's end of one other host: the agent there, its control channel and the link's beats. Main thread.
class RemoteHost {
 public:
  /// Starts the agent and sends it its order, of which the caller gives everything but the beat's port and key. `own`:
  /// this machine's address on the route to the host. Throws std::runtime_error when the command cannot be started.
  RemoteHost(const config::HostEntry& entry, AgentOrder order, in_addr own, in_addr there, HostLimits limits,
             const HostListener& listener, clock::EmergencyStop& emergency_stop);

  /// Descriptors that become readable when `look` has something to do.
  std::vector<int> descriptors() const;
  /// Processes what the agent has sent, and detects when it is gone or silent. A task may seem to succeed because its
  /// processes there were instructed to end: what the agent sent before it received the stop counts even after that.
  void poll();
  /// What is not ready yet: processes, the agent, its clock. Empty when all are ready.
  std::vector<std::string> missing() const;
  /// Tick 0 is at `epoch_ns` of this machine's CLOCK_MONOTONIC. From now on silence counts as a loss.
  void start(std::int64_t epoch_ns);
  void stop();
  bool ended() noexcept { return agent_.ended(); }
  void kill() noexcept { agent_.signal(SIGKILL); }

  const std::string& name() const noexcept { return name_; }
  /// When the last step of a task arrived, CLOCK_MONOTONIC, ns; 0: never.
  std::int64_t step_at() const noexcept { return step_at_; }
  /// The error bound of its clock, ns; 0 while the clock is unknown.
  std::int64_t clock_error_ns() const;
  /// Whether every press and reset of the runner's emergency stop has arrived there.
  bool follows_emergency_stop() const noexcept { return link_.peer_follows(); }
  /// One line about link and clock, for the report.
  std::string summary() const;

 private:
  void hear(const std::string& line);
  /// Reports how it ended, as soon as the kernel knows.
  void poll_agent();
  void poll_link();
  void fail(process::ExitCode code, const std::string& reason);

  const std::string name_;
  const in_addr there_;
  const HostLimits limits_;
  const HostListener& listener_;
  HostLink link_;
  std::unique_ptr<LineChannel> channel_;
  Child agent_;
  bool greeted_ = false;
  bool told_missing_ = false;
  std::string missing_;
  bool stopped_ = false;     // it has been instructed to stop
  bool said_ended_ = false;  // it has reported its end
  std::int64_t step_at_ = 0;
  std::int64_t gone_since_ = 0;  // CLOCK_MONOTONIC, ns; 0: it is present
  bool told_gone_ = false;
};

}  // namespace mrroc::cli
