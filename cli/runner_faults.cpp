// The part of the runner that injects faults into processes.
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <string_view>

#include "cli/runner.hpp"

namespace mrroc::cli {

namespace {

constexpr double kPatienceWithSignal = 2;  // s

/// False: the process is stopped, has ended, or is no more.
bool is_at_work(pid_t pid) {
  std::ifstream file("/proc/" + std::to_string(pid) + "/stat");
  std::string stat;
  std::getline(file, stat);
  const std::size_t name = stat.rfind(')');
  return name != std::string::npos && name + 2 < stat.size() &&
         std::string_view{"TtZX"}.find(stat[name + 2]) == std::string_view::npos;
}

}  // namespace

void Runner::check_faults() const {
  std::string known;
  for (const PlannedProcess& process : plan_) known += (known.empty() ? "" : ", ") + process.name;
  const auto find = [&](const faults::Fault& fault, const std::string& name) {
    const auto found = std::find_if(plan_.begin(), plan_.end(), [&](const auto& each) { return each.name == name; });
    const std::string beginning = "the fault \"" + fault.text + "\": ";
    if (found == plan_.end())
      throw std::invalid_argument(beginning + "the deployment has no process '" + name + "', it has " + known);
    if (!found->host.empty())
      throw std::invalid_argument(beginning + name + " is on host " + found->host +
                                  ", faults are injected on this machine only");
    return *found;
  };
  for (const faults::Fault& fault : faults_.all()) {
    find(fault, fault.process);
    if (fault.at_step && !find(fault, fault.counter).has_task)
      throw std::invalid_argument("the fault \"" + fault.text + "\": '" + fault.counter +
                                  "' counts no steps, expected mp or the name of a robot");
  }
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

void Runner::tell_faults_left() {
  for (std::size_t i = 0; i < faults_.all().size(); ++i)
    if (!told_faults_.contains(i)) progress_.message("not injected, the run ended before: " + faults_.all()[i].text);
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
  const Child* const child = crew_.find(fault.process);
  if (child == nullptr) return;
  int number = SIGKILL;
  if (fault.kind == faults::Kind::halt) number = SIGSTOP;
  if (fault.kind == faults::Kind::end) number = SIGTERM;
  {
    const std::lock_guard lock(struck_mutex_);
    struck_.emplace(fault.process, operator_clock_->wall_seconds());
  }
  child->send(number);
  if (deployment_.clock == config::ClockMode::real) return;
  const double deadline = operator_clock_->wall_seconds() + kPatienceWithSignal;
  // not by waitpid: who waits for it is the main thread, which then says what has happened
  while (is_at_work(child->pid()) && operator_clock_->wall_seconds() < deadline) usleep(200);
  clock_.participant_died(fault.process);
  clock_.stop();
}

}  // namespace mrroc::cli
