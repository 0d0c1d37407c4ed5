#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "cli/processes/crew.hpp"
#include "cli/processes/process_plan.hpp"
#include "clock/host.hpp"
#include "faults/fault_plan.hpp"

namespace mrroc::cli {

/// Injects a run's faults, as far as the runner does it: sets off those of a tick, sends the signals of those that
/// strike a process, and says what has been injected. Main thread; the signals are sent by the clock's.
class FaultInjector {
 public:
  /// Parses the faults. `show` is given the lines for the operator. References must outlive it. Throws
  /// std::invalid_argument: a fault is wrong, names a process that is not there or on another host, or counts the steps
  /// of one that has none.
  FaultInjector(const std::vector<std::string>& texts, const std::vector<PlannedProcess>& plan, clock::ClockHost& clock,
                const Crew& crew, bool simulated, std::function<void(const std::string& line)> show);

  /// When all processes have been started, before the clock.
  void schedule();
  /// Tells of those that have been set off since the last call.
  void tell();
  /// At the end: tells of those that never were.
  void tell_left();
  /// Those that a signal was sent to. In simulated time the others may have ended in consequence before anybody looks.
  std::vector<std::string> struck();
  /// Under the real clock: tells how long it took to see what a signal has done to this process.
  void tell_noticed(const std::string& process);
  /// A fault has begun the end of the run: whatever a task says from now on is a consequence.
  bool ends_run() const noexcept { return clock_.stop_tick() != kNever; }

 private:
  void look(std::size_t index, Tick tick);
  void strike(const faults::InjectedFault& fault);

  faults::FaultPlan plan_;
  clock::ClockHost& clock_;
  const Crew& crew_;
  bool simulated_;
  std::function<void(const std::string&)> show_;
  std::set<std::size_t> told_;                  // indices
  std::map<std::string, std::int64_t> struck_;  // when a signal was sent to a process, ns
  std::mutex struck_mutex_;
};

}  // namespace mrroc::cli
