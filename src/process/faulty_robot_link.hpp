#pragma once

#include <vector>

#include "clock/clock.hpp"
#include "faults/fault_plan.hpp"
#include "mrroc/robot_link.hpp"

namespace mrroc::process {

/// A robot's link with injected faults: commands that are lost, late or wrong, as long as a fault is active. Task's
/// thread.
class FaultyRobotLink final : public RobotLink {
 public:
  /// `link` and `clock` must outlive it. `patience`: timeout for the reply to a lost command, ticks.
  FaultyRobotLink(RobotLink& link, std::vector<faults::FaultSwitch> faults, clock::Clock& clock, Tick patience)
      : link_(link), faults_(std::move(faults)), clock_(clock), patience_(patience) {}

  /// Waits while commands are delayed; throws Stopped.
  void send(const RobotCommand& command) override;
  /// After a lost command: throws SystemError(process_silent) when its reply is missed.
  void receive(RobotState& state) override;

 private:
  RobotLink& link_;
  std::vector<faults::FaultSwitch> faults_;
  void wait_until(Tick tick);

  clock::Clock& clock_;
  Tick patience_;
  Tick missed_at_ = kNever;  ///< of a lost command
};

}  // namespace mrroc::process
