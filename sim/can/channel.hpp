#pragma once

#include <optional>
#include <vector>

#include "can/frame.hpp"
#include "config/drives/drive_table.hpp"

namespace mrroc::sim {

/// One axis of a simulated drive with several: for the drive with one axis behind it, its objects are those of the
/// first axis and its PDOs have the numbers from 1 on. What the axes have in common is answered and sent by the first
/// of them: boot-up message, heartbeats. One thread.
class Channel {
 public:
  Channel(const config::DriveTable& table, const config::DriveEntry& entry);

  /// A frame of the bus as the axis takes it; nothing: it is for another axis.
  std::optional<can::Frame> received(const can::Frame& frame) const;
  /// A frame of the axis as its node sends it; nothing: the first axis sends it.
  std::optional<can::Frame> sent(const can::Frame& frame) const;

 private:
  /// An axis of the node.
  struct Axis {
    int channel = 1, first_pdo = 1;
  };
  const Axis* axis_of(std::uint16_t index) const;

  canopen::NodeId node_;
  std::vector<Axis> axes_;  ///< of the node, in the axes' order
  std::size_t own_ = 0;     ///< place in it
};

}  // namespace mrroc::sim
