#pragma once

#include <string>
#include <vector>

#include "clock/clock.hpp"
#include "faults/fault.hpp"
#include "mrroc/robot_parameters.hpp"

namespace mrroc::faults {

/// Tells whether one fault of the plan is in force. Any thread; neither allocates nor locks.
class FaultSwitch {
 public:
  FaultSwitch(const InjectedFault& fault, std::size_t index, const clock::Clock& clock)
      : fault_(fault), index_(index), clock_(&clock) {}
  const InjectedFault& fault() const noexcept { return fault_; }
  /// At tick `tick`: from the tick at which it was set off, as long as it lasts.
  bool on(Tick tick) const noexcept {
    const Tick begin = clock_->fault_tick(index_);
    return begin != kNever && tick >= begin && tick - begin < fault_.duration;
  }

 private:
  InjectedFault fault_;
  std::size_t index_;
  const clock::Clock* clock_;
};

/// Throws NonFatalError (invalid_argument): one strikes an axis that the robot does not have.
void check_axes(const std::vector<FaultSwitch>& faults, const RobotParameters& robot);

/// The faults to be injected into one run, as every process of it knows them (Arguments::faults). When each is set off
/// stands in the clock's memory: at once for a tick, by the process whose steps are counted else.
class FaultPlan {
 public:
  FaultPlan() = default;
  /// Parses them; throws std::invalid_argument: a fault is wrong, or there are more than clock::kMaxFaults.
  explicit FaultPlan(const std::vector<std::string>& texts);

  const std::vector<InjectedFault>& all() const noexcept { return faults_; }
  /// Of those that strike `process` on its own (not by a signal of the runner); `clock` must outlive them.
  std::vector<FaultSwitch> of(const std::string& process, const clock::Clock& clock) const;
  /// Sets off, at tick `tick` + 1, what waits for step number `step` of process `process`. Allocates nothing.
  void count_step(const std::string& process, std::uint64_t step, Tick tick, clock::Clock& clock) const noexcept;

 private:
  std::vector<InjectedFault> faults_;
};

}  // namespace mrroc::faults
