#pragma once

#include <string>
#include <vector>

#include "clock/clock.hpp"
#include "faults/fault.hpp"
#include "mrroc/robot_parameters.hpp"

namespace mrroc::faults {

/// Reports whether one fault of the plan is active. Any thread; neither allocates nor locks.
class FaultSwitch {
 public:
  FaultSwitch(const InjectedFault& fault, std::size_t index, const clock::Clock& clock)
      : fault_(fault), index_(index), clock_(&clock) {}
  const InjectedFault& fault() const noexcept { return fault_; }
  /// At tick `tick`: from the tick at which it was triggered, for its duration.
  bool on(Tick tick) const noexcept {
    const Tick begin = clock_->fault_tick(index_);
    return begin != kNever && tick >= begin && tick - begin < fault_.duration;
  }

 private:
  InjectedFault fault_;
  std::size_t index_;
  const clock::Clock* clock_;
};

/// Throws NonFatalError (invalid_argument): a fault names an axis that the robot does not have.
void check_axes(const std::vector<FaultSwitch>& faults, const RobotParameters& robot);

/// The faults to be injected into one run, which every process of it receives (Arguments::faults). The clock's memory
/// holds the tick of each: fixed from the start for a tick, else set by the process whose steps are counted.
class FaultPlan {
 public:
  FaultPlan() = default;
  /// Parses them; throws std::invalid_argument: a fault is invalid, or there are more than clock::kMaxFaults.
  explicit FaultPlan(const std::vector<std::string>& texts);

  const std::vector<InjectedFault>& all() const noexcept { return faults_; }
  /// The faults that `process` causes itself (not by a signal of the runner); `clock` must outlive them.
  std::vector<FaultSwitch> of(const std::string& process, const clock::Clock& clock) const;
  /// Triggers, at tick `tick` + 1, the faults that wait for step number `step` of process `process`. Allocates nothing.
  void count_step(const std::string& process, std::uint64_t step, Tick tick, clock::Clock& clock) const noexcept;

 private:
  std::vector<InjectedFault> faults_;
};

}  // namespace mrroc::faults
