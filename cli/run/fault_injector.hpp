#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "cli/processes/process_group.hpp"
#include "cli/processes/process_plan.hpp"
#include "clock/host.hpp"
#include "config/deployment.hpp"
#include "faults/fault_plan.hpp"

namespace mrroc::cli {

/// Throws std::invalid_argument when a fault names a process that does not exist or is on another host, or an axis that
/// its robot does not have, or counts the steps of a process without steps.
void check_targets(const faults::FaultPlan& faults, const std::vector<PlannedProcess>& plan,
                   const config::Deployment& deployment);

/// Injects a run's faults that are the runner's task: triggers those of a tick, sends the signals to processes, and
/// reports each injected fault. Main thread; the clock's thread sends the signals.
class FaultInjector {
 public:
  /// Parses the faults. `show` displays a line to the operator. References must outlive it. Throws
  /// std::invalid_argument when a fault is invalid, and as `check_targets`.
  FaultInjector(const std::vector<std::string>& texts, const std::vector<PlannedProcess>& plan,
                const config::Deployment& deployment, clock::ClockHost& clock, const ProcessGroup& group,
                bool simulated, std::function<void(const std::string& line)> show);

  /// Call it when all processes have been started, before the clock.
  void schedule();
  /// Reports the faults that were triggered since the last call.
  void tell();
  /// At the end: reports the faults that were never triggered.
  void tell_left();
  /// Processes that received a signal. In simulated time others may have ended in consequence before the next check.
  std::vector<std::string> struck();
  /// Under the real clock: reports how long it took to detect the effect of a signal on this process.
  void tell_noticed(const std::string& process);
  /// A fault has begun the end of the run: later reports of a task are consequences.
  bool ends_run() const noexcept { return clock_.stop_tick() != kNever; }

 private:
  void update(std::size_t index, Tick tick);
  void strike(const faults::InjectedFault& fault);

  faults::FaultPlan plan_;
  clock::ClockHost& clock_;
  const ProcessGroup& group_;
  bool simulated_;
  std::function<void(const std::string&)> show_;
  std::set<std::size_t> told_;                  // indices
  std::map<std::string, std::int64_t> struck_;  // when a signal was sent to a process, ns
  std::mutex struck_mutex_;
};

}  // namespace mrroc::cli
