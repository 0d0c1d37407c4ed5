#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "can/bus.hpp"
#include "can/bus_error.hpp"
#include "canopen/identifiers.hpp"

namespace mrroc::cli {

/// What a node of a CANopen network reports about itself; a value that it did not report is missing.
struct FoundNode {
  canopen::NodeId node = 0;
  std::optional<canopen::NmtState> state;  ///< from its last heartbeat
  std::optional<std::uint32_t> device_type, vendor, product, revision, serial;
  std::string name;  ///< in quotes
};

struct ScanResult {
  std::vector<FoundNode> nodes;               ///< by number
  can::BusError error = can::BusError::none;  ///< the last error that the bus reported
};

/// Requests the device type of every node 1..127 at once, then the other values of the nodes that answer, and listens
/// for heartbeats meanwhile. Ends `patience` (ns) after its last request: well under a second for a timeout of half a
/// second. It sends SDO requests and nothing else, so it may be used on a network in operation. One thread.
ScanResult scan(can::Bus& bus, std::int64_t patience);

/// A table, one line for each node.
std::string scan_text(const std::vector<FoundNode>& nodes);

/// What to check when no node has answered.
std::string silence_text(const std::string& interface, can::BusError error, double patience);

}  // namespace mrroc::cli
