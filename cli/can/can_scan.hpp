#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "can/bus.hpp"
#include "can/bus_error.hpp"
#include "canopen/identifiers.hpp"

namespace mrroc::cli {

/// What a node of a CANopen network says of itself; what it has not said is missing.
struct FoundNode {
  canopen::NodeId node = 0;
  std::optional<canopen::NmtState> state;  ///< of its last heartbeat
  std::optional<std::uint32_t> device_type, vendor, product, revision, serial;
  std::string name;  ///< in quotes
};

struct ScanResult {
  std::vector<FoundNode> nodes;               ///< by number
  can::BusError error = can::BusError::none;  ///< the last that the bus has reported
};

/// Asks every node 1..127 for its device type, all of them before it waits, and those that answer for the rest; listens
/// for heartbeats meanwhile. Ends `patience` (ns) after its last request: well under a second where that is half of
/// one. It sends SDO requests and nothing else, so it may be used on a network in operation. One thread.
ScanResult scan(can::Bus& bus, std::int64_t patience);

/// A table, one line for each node.
std::string scan_text(const std::vector<FoundNode>& nodes);

/// What to look at when no one has answered.
std::string silence_text(const std::string& interface, can::BusError error, double patience);

}  // namespace mrroc::cli
