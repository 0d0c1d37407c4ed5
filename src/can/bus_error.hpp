#pragma once

#include <cstdint>

#include "can/frame.hpp"

namespace mrroc::can {

/// Errors of a bus: those that its controller reports (linux/can/error.h), the most severe one of an error frame, and
/// those that its user detects.
enum class BusError : std::uint8_t {
  none,
  bus_off,         ///< the controller has left the bus: too many errors of its own
  passive,         ///< more than 127 errors: it may no longer destroy frames of others
  warning,         ///< more than 96 errors
  overflow,        ///< frames were lost: the controller's buffer was full
  no_acknowledge,  ///< no node has received the frame: a cable, the bit rate, no other node
  protocol,        ///< a frame was broken on the wire: form, stuffing, checksum
  transceiver,     ///< the wires: short circuit, no connection
  recovered,       ///< the controller is on the bus again
  queue_full,      ///< frames to be sent are refused
  down,            ///< the interface has been switched off, or has gone
  foreign_master,  ///< another node sends frames that only the master may send
  other
};

/// `frame.error` must be true. Never throws.
BusError bus_error_of(const Frame& frame) noexcept;

/// After these errors the bus passes no frames in either direction.
constexpr bool stops_the_bus(BusError error) noexcept { return error == BusError::bus_off || error == BusError::down; }

/// "bus off: the controller has left the bus after too many errors".
const char* describe(BusError error) noexcept;

}  // namespace mrroc::can
