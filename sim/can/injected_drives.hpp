#pragma once

#include <vector>

#include "faults/fault_plan.hpp"
#include "sim/can/drive_node.hpp"

namespace mrroc::sim {

/// Injects the faults of single simulated drives of a run; it ignores those of I/O nodes. One thread.
class InjectedDrives {
 public:
  /// Throws NonFatalError: an axis that the robot does not have.
  InjectedDrives(const std::vector<faults::FaultSwitch>& faults, const RobotParameters& robot);

  /// At tick `tick` of the plant, before the nodes answer: begins and ends faults. `now`: the nodes' time, ns.
  void apply(Tick tick, std::int64_t now, std::vector<DriveNode>& nodes);

 private:
  struct Injected {
    faults::FaultSwitch fault;
    bool on = false;
  };
  std::vector<Injected> faults_;
};

}  // namespace mrroc::sim
