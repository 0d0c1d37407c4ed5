#pragma once

#include <cstdint>
#include <vector>

#include "config/drives/io_table.hpp"
#include "faults/fault_plan.hpp"
#include "mrroc/signals.hpp"
#include "sim/can/io_node.hpp"

namespace mrroc::sim {

/// Injects the faults of simulated I/O nodes and of their inputs; it ignores those of drives. One thread.
class InjectedIo {
 public:
  /// Throws NonFatalError (invalid_argument): a node or an input that `io` does not have.
  InjectedIo(const std::vector<faults::FaultSwitch>& faults, const config::IoTable& io);

  /// At tick `tick` of the plant, before the nodes measure `inputs` and answer: begins and ends faults of the nodes,
  /// and sets the inputs that stick, in the terminals' own unit. `now`: the nodes' time, ns.
  void apply(Tick tick, std::int64_t now, std::vector<IoNode>& nodes, ControllerIo& inputs);

 private:
  struct Injected {
    faults::FaultSwitch fault;
    std::size_t node = 0;  ///< its place in the table, of the faults of a node
    bool on = false;
  };
  std::vector<Injected> faults_;
};

}  // namespace mrroc::sim
