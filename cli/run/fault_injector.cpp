#include "cli/run/fault_injector.hpp"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "clock/wall/monotonic.hpp"
#include "config/entries/robot_orders.hpp"

namespace mrroc::cli {

namespace {

constexpr std::int64_t kSignalTimeout = 15 * clock::kSecond;  // a process that ends in order has much to close

int signal_of(faults::Kind kind) {
  if (kind == faults::Kind::halt) return SIGSTOP;
  return kind == faults::Kind::end ? SIGTERM : SIGKILL;
}

[[noreturn]] void refuse(const faults::InjectedFault& fault, const std::string& why) {
  throw std::invalid_argument("the fault \"" + fault.text + "\": " + why);
}

/// The process `name` of the fault, here.
const PlannedProcess& find(const faults::InjectedFault& fault, const std::vector<PlannedProcess>& plan,
                           const std::string& name) {
  std::string known;
  for (const PlannedProcess& process : plan) {
    known += (known.empty() ? "" : ", ") + process.name;
    if (process.name != name) continue;
    if (process.host.empty()) return process;
    refuse(fault, name + " is on host " + process.host + ", faults are injected on this machine only");
  }
  refuse(fault, "the deployment has no process '" + name + "', it has " + known);
}

}  // namespace

void check_targets(const faults::FaultPlan& faults, const std::vector<PlannedProcess>& plan,
                   const config::Deployment& deployment) {
  for (const faults::InjectedFault& fault : faults.all()) {
    find(fault, plan, fault.process);
    if (fault.at_step && !find(fault, plan, fault.counter).has_task)
      refuse(fault, "'" + fault.counter + "' counts no steps, expected mp or the name of a robot");
    for (const config::RobotEntry& robot : deployment.robots) {
      if (robot.edp_process() != fault.process) continue;
      const std::size_t axes = config::parameters_of(robot).axes.size();
      if (fault.axis >= axes) refuse(fault, robot.type + " has " + std::to_string(axes) + " axes");
    }
  }
}

FaultInjector::FaultInjector(const std::vector<std::string>& texts, const std::vector<PlannedProcess>& plan,
                             const config::Deployment& deployment, clock::ClockHost& clock, const ProcessGroup& group,
                             bool simulated, std::function<void(const std::string&)> show)
    : plan_(texts), clock_(clock), group_(group), simulated_(simulated), show_(std::move(show)) {
  check_targets(plan_, plan, deployment);
}

void FaultInjector::schedule() {
  for (std::size_t i = 0; i < plan_.all().size(); ++i) {
    const faults::InjectedFault& fault = plan_.all()[i];
    if (!fault.at_step) clock_.set_off_fault(i, fault.when);
    const Tick first = fault.at_step ? 1 : fault.when;
    clock_.at_tick(first, [this, i, first](Tick) { update(i, first); });
  }
}

/// An event of tick `tick`: injects the fault when it is in force, else checks again at the next tick.
void FaultInjector::update(std::size_t index, Tick tick) {
  if (clock_.fault_tick(index) > tick) {
    clock_.at_tick(tick + 1, [this, index, tick](Tick) { update(index, tick + 1); });
    return;
  }
  const faults::InjectedFault& fault = plan_.all()[index];
  if (faults::is_signal(fault.kind)) strike(fault);
}

/// Sends the signal and waits until it has taken effect, so that no simulated tick passes.
void FaultInjector::strike(const faults::InjectedFault& fault) {
  const Child* const child = group_.find(fault.process);
  if (child == nullptr) return;
  const std::int64_t now = clock::monotonic_ns();
  {
    const std::lock_guard lock(struck_mutex_);
    struck_.emplace(fault.process, now);
  }
  child->signal(signal_of(fault.kind));
  if (!simulated_) return;
  // only `halt` ends in a process that is stopped; others may be so on their way, by a debugger or a leak check
  const auto acts = [&] { return fault.kind == faults::Kind::halt ? child->is_at_work() : child->lives(); };
  while (acts() && clock::monotonic_ns() < now + kSignalTimeout) usleep(200);
  clock_.participant_died(fault.process);
  clock_.stop();
}

std::vector<std::string> FaultInjector::struck() {
  const std::lock_guard lock(struck_mutex_);
  std::vector<std::string> names;
  for (const auto& [name, time] : struck_) names.push_back(name);
  return names;
}

void FaultInjector::tell() {
  for (std::size_t i = 0; i < plan_.all().size(); ++i) {
    // the tick of the injection is not visible yet while the signal is sent
    if (told_.contains(i) || clock_.fault_tick(i) > clock_.tick() + 1) continue;
    told_.insert(i);
    show_("injected at tick " + std::to_string(clock_.fault_tick(i)) + ": " + plan_.all()[i].text);
  }
}

void FaultInjector::tell_left() {
  for (std::size_t i = 0; i < plan_.all().size(); ++i)
    if (!told_.contains(i)) show_("not injected, the run ended before: " + plan_.all()[i].text);
}

void FaultInjector::tell_noticed(const std::string& process) {
  if (simulated_) return;
  const std::lock_guard lock(struck_mutex_);
  const auto struck = struck_.find(process);
  if (struck == struck_.end()) return;
  const double after = static_cast<double>(clock::monotonic_ns() - struck->second) * 1e-6;
  show_("noticed after " + std::to_string(after) + " ms: " + process);
}

}  // namespace mrroc::cli
