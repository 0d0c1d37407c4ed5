#include "faults/fault_plan.hpp"

#include <stdexcept>

#include "clock/clock_memory.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::faults {

FaultPlan::FaultPlan(const std::vector<std::string>& texts) {
  if (texts.size() > clock::kMaxFaults)
    throw std::invalid_argument(std::to_string(texts.size()) + " faults to inject, expected at most " +
                                std::to_string(clock::kMaxFaults));
  for (const std::string& text : texts) faults_.push_back(parse_fault(text));
}

std::vector<FaultSwitch> FaultPlan::of(const std::string& process, const clock::Clock& clock) const {
  std::vector<FaultSwitch> switches;
  for (std::size_t i = 0; i < faults_.size(); ++i)
    if (faults_[i].process == process && !is_signal(faults_[i].kind)) switches.emplace_back(faults_[i], i, clock);
  return switches;
}

void check_axes(const std::vector<FaultSwitch>& faults, const RobotParameters& robot) {
  for (const FaultSwitch& each : faults)
    if (each.fault().axis >= robot.axes.size())
      throw NonFatalError(ErrorCode::invalid_argument, "the fault \"" + each.fault().text + "\": " + robot.type +
                                                           " has " + std::to_string(robot.axes.size()) + " axes");
}

void FaultPlan::count_step(const std::string& process, std::uint64_t step, Tick tick,
                           clock::Clock& clock) const noexcept {
  for (std::size_t i = 0; i < faults_.size(); ++i)
    if (faults_[i].at_step && faults_[i].when == step && faults_[i].counter == process)
      clock.set_off_fault(i, tick + 1);
}

}  // namespace mrroc::faults
