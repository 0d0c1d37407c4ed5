// The part of the runner that injects faults into processes.
#include <signal.h>
#include <sys/wait.h>

#include <algorithm>
#include <stdexcept>

#include "cli/runner.hpp"

namespace mrroc::cli {

void Runner::check_faults() const {
  std::string known;
  for (const PlannedProcess& process : plan_) known += (known.empty() ? "" : ", ") + process.name;
  for (const PlannedProcess& process : plan_)
    for (const faults::Fault& fault : faults_.all())
      if (process.name == fault.process && !process.host.empty())
        throw std::invalid_argument("the fault \"" + fault.text + "\": " + process.name + " is on host " +
                                    process.host + ", faults are injected on this machine only");
  for (const faults::Fault& fault : faults_.all())
    for (const std::string& name : {fault.process, fault.at_step ? fault.counter : fault.process})
      if (std::none_of(plan_.begin(), plan_.end(), [&](const PlannedProcess& each) { return each.name == name; }))
        throw std::invalid_argument("the fault \"" + fault.text + "\": the deployment has no process '" + name +
                                    "', it has " + known);
}

void Runner::schedule_faults() {
  for (std::size_t i = 0; i < faults_.all().size(); ++i) {
    const faults::Fault& fault = faults_.all()[i];
    if (!fault.at_step) clock_.set_off_fault(i, fault.when);
    const Tick first = fault.at_step ? 1 : fault.when;
    clock_.at_tick(first, [this, i, first] { look_at_fault(i, first); });
  }
}

void Runner::tell_faults() {
  for (std::size_t i = 0; i < faults_.all().size(); ++i) {
    // the tick that it strikes at is not visible yet while it does
    if (told_faults_.contains(i) || clock_.fault_tick(i) > clock_.tick() + 1) continue;
    told_faults_.insert(i);
    progress_.message("injected at tick " + std::to_string(clock_.fault_tick(i)) + ": " + faults_.all()[i].text);
  }
}

void Runner::tell_notice(const std::string& process) {
  if (deployment_.clock != config::ClockMode::real) return;
  const std::lock_guard lock(struck_mutex_);
  const auto struck = struck_.find(process);
  if (struck == struck_.end()) return;
  const double after = operator_clock_->wall_seconds() - struck->second;
  progress_.message("noticed after " + std::to_string(after * 1e3) + " ms: " + process);
}

void Runner::look_at_fault(std::size_t index, Tick tick) {
  if (clock_.fault_tick(index) > tick) {
    clock_.at_tick(tick + 1, [this, index, tick] { look_at_fault(index, tick + 1); });
    return;
  }
  const faults::Fault& fault = faults_.all()[index];
  if (faults::target_of(fault.kind) == faults::Target::any_process) strike(fault);
}

void Runner::strike(const faults::Fault& fault) {
  const pid_t pid = crew_.pid(fault.process);
  if (pid <= 0) return;  // kill() would take it for everybody
  int number = SIGKILL;
  if (fault.kind == faults::Kind::halt) number = SIGSTOP;
  if (fault.kind == faults::Kind::end) number = SIGTERM;
  {
    const std::lock_guard lock(struck_mutex_);
    struck_.emplace(fault.process, operator_clock_->wall_seconds());
  }
  kill(pid, number);
  if (deployment_.clock == config::ClockMode::real) return;
  siginfo_t info{};
  // without reaping it: that is the main thread's, which then says what has happened
  waitid(P_PID, static_cast<id_t>(pid), &info, WEXITED | WSTOPPED | WNOWAIT);
  clock_.participant_died(fault.process);
  clock_.stop();
}

}  // namespace mrroc::cli
