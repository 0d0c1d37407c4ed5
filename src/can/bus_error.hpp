#pragma once

#include <cstdint>

#include "can/frame.hpp"

namespace mrroc::can {

/// What is wrong with a bus: what its controller reports (linux/can/error.h), the most severe of what one error frame
/// says, and what its user finds.
enum class BusError : std::uint8_t {
  none,
  bus_off,         ///< the controller has left the bus: too many errors of its own
  passive,         ///< more than 127 errors: it may no longer destroy what others send
  warning,         ///< more than 96 errors
  overflow,        ///< frames were lost: the controller's buffer was full
  no_acknowledge,  ///< no one has received what was sent: a cable, the bit rate, no other node
  protocol,        ///< a frame was broken on the wire: form, stuffing, checksum
  transceiver,     ///< the wires: short circuit, no connection
  recovered,       ///< the controller is on the bus again
  queue_full,      ///< what is sent is not taken any more
  down,            ///< the interface has been switched off, or has gone
  foreign_master,  ///< another node sends what only the master may
  other
};

/// `frame.error` must be true. Never throws.
BusError bus_error_of(const Frame& frame) noexcept;

/// "bus off: the controller has left the bus after too many errors".
const char* describe(BusError error) noexcept;

}  // namespace mrroc::can
