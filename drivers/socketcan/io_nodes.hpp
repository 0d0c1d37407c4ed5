#pragma once

#include <string>
#include <vector>

#include "can/bus.hpp"
#include "drivers/socketcan/io_node.hpp"
#include "edp/hardware.hpp"

namespace mrroc::edp {

/// The I/O nodes of one robot: the terminals of its controller. Allocates in the constructor only; one thread; never
/// throws.
class IoNodes {
 public:
  /// `drives`: the table of drives on the same bus; `period` in s.
  IoNodes(const config::IoTable& table, const config::DriveTable& drives, double period);

  std::vector<IoNode>& all() noexcept { return nodes_; }
  const std::vector<IoNode>& all() const noexcept { return nodes_; }
  /// Appends filters for the frames of the nodes, and for those that only their master may send.
  void add_filters(std::vector<can::Filter>& filters) const;

  /// Writes inputs and, unless `input` has a fault that is at least as severe, the first fault of a node.
  void read(Tick tick, HardwareInput& input) const noexcept;
  /// From now on the outputs; one that is on, or not 0, at a terminal that no node has is a fault.
  void set_outputs(const ControllerIo& outputs) noexcept;
  const ControllerIo& outputs() const noexcept { return outputs_; }
  /// Clears the fault of an output that no node has.
  void clear() noexcept { missing_ = kNone; }

 private:
  static constexpr int kNone = -1;

  std::vector<IoNode> nodes_;
  int digital_outputs_ = 0, analog_outputs_ = 0;  ///< of all nodes
  ControllerIo outputs_;
  int missing_ = kNone;  ///< output without a node: kDigital + i is the analogue one i
};

}  // namespace mrroc::edp
