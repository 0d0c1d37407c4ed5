#pragma once

#include <cstdint>
#include <optional>

#include "canopen/pdo_mapping.hpp"
#include "sim/can/object_store.hpp"

namespace mrroc::sim {

/// One PDO of a simulated node.
struct NodePdo {
  canopen::PdoMapping mapping;
  std::uint32_t identifier = 0;
  int transmission = 255;

  /// Whether it is sent at the SYNC with this number since the node was started.
  bool is_due(int sync) const noexcept { return transmission >= 1 && transmission <= 240 && sync % transmission == 0; }
  /// Whether received values wait for the next SYNC.
  bool waits_for_sync() const noexcept { return transmission <= 240; }

  /// The frame with the values of `store`.
  can::Frame frame(const ObjectStore& store) const;
  /// Takes the values of a received frame. False: it is too short, nothing is taken.
  bool take(const can::Frame& received, ObjectStore& store) const;
};

/// The PDO with these parameters (1400h.., 1800h..) as it is configured; nothing when it is not used.
std::optional<NodePdo> configured_pdo(const ObjectStore& store, std::uint16_t parameters);

}  // namespace mrroc::sim
