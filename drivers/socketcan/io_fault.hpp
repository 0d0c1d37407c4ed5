#pragma once

#include <cstdint>
#include <variant>

#include "canopen/identifiers.hpp"
#include "canopen/objects.hpp"
#include "canopen/sdo.hpp"
#include "edp/safety/fault.hpp"

namespace mrroc::edp {

/// The node has booted again, or reports that it is not operational.
struct IoRestarted {};

/// The node rejects a value of its set-up after a restart.
struct IoSetupRefused {
  canopen::Object object;
  canopen::SdoAbort reason{};
};

/// More than `allowed` SYNCs in a row without TPDO `pdo`, or only with ones that are too short.
struct IoSilent {
  int pdo = 0;
  int allowed = 0;
};

/// The last heartbeat is too old; ticks.
struct IoHeartbeatLost {
  Tick age = 0, allowed = 0;
};

/// The node has sent an EMCY with this error code, and has not reported its end before the last reset.
struct IoError {
  std::uint16_t code = 0;
};

/// A fault of an I/O node; monostate: none. Each is ErrorCode::io_fault: the drives still follow, so the robot stops
/// within its limits.
using IoFault = std::variant<std::monostate, IoRestarted, IoSetupRefused, IoSilent, IoHeartbeatLost, IoError>;

/// Text of the fault, with the node's number; empty without a fault. Allocates nothing, never throws.
DriverText describe(canopen::NodeId node, const IoFault& fault) noexcept;

}  // namespace mrroc::edp
