#pragma once

#include <vector>

#include "clock/clock.hpp"
#include "faults/fault_plan.hpp"
#include "mrroc/robot_link.hpp"

namespace mrroc::process {

/// A robot's link with injected faults: commands that are lost, late or wrong, as long as a fault is in force. The
/// task's thread.
class FaultyRobotLink final : public RobotLink {
 public:
  /// `link` and `clock` must outlive it.
  FaultyRobotLink(RobotLink& link, std::vector<faults::FaultSwitch> faults, clock::Clock& clock)
      : link_(link), faults_(std::move(faults)), clock_(clock) {}

  /// Waits while commands are delayed; throws Stopped.
  void send(const RobotCommand& command) override;
  void receive(RobotState& state) override { link_.receive(state); }

 private:
  RobotLink& link_;
  std::vector<faults::FaultSwitch> faults_;
  clock::Clock& clock_;
};

}  // namespace mrroc::process
