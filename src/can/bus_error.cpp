#include "can/bus_error.hpp"

#include <linux/can/error.h>

namespace mrroc::can {

BusError bus_error_of(const Frame& frame) noexcept {
  const std::uint32_t classes = frame.id;
  if ((classes & CAN_ERR_BUSOFF) != 0) return BusError::bus_off;
  const std::uint8_t controller = (classes & CAN_ERR_CRTL) != 0 ? frame.data[1] : std::uint8_t{0};
  if ((controller & (CAN_ERR_CRTL_RX_PASSIVE | CAN_ERR_CRTL_TX_PASSIVE)) != 0) return BusError::passive;
  if ((controller & (CAN_ERR_CRTL_RX_OVERFLOW | CAN_ERR_CRTL_TX_OVERFLOW)) != 0) return BusError::overflow;
  // drivers report a missing acknowledge in either form
  const bool at_acknowledge = (classes & CAN_ERR_PROT) != 0 && frame.data[3] == CAN_ERR_PROT_LOC_ACK;
  if ((classes & CAN_ERR_ACK) != 0 || at_acknowledge) return BusError::no_acknowledge;
  if ((classes & CAN_ERR_TRX) != 0) return BusError::transceiver;
  if ((controller & (CAN_ERR_CRTL_RX_WARNING | CAN_ERR_CRTL_TX_WARNING)) != 0) return BusError::warning;
  if ((classes & (CAN_ERR_PROT | CAN_ERR_BUSERROR)) != 0) return BusError::protocol;
  if ((controller & CAN_ERR_CRTL_ACTIVE) != 0 || (classes & CAN_ERR_RESTARTED) != 0) return BusError::recovered;
  return BusError::other;
}

const char* describe(BusError error) noexcept {
  switch (error) {
    case BusError::none:
      return "no error";
    case BusError::bus_off:
      return "bus off: the controller has left the bus after too many errors";
    case BusError::passive:
      return "error passive: the controller has counted more than 127 errors";
    case BusError::warning:
      return "error warning: the controller has counted more than 96 errors";
    case BusError::overflow:
      return "overflow: the controller has lost frames";
    case BusError::no_acknowledge:
      return "no acknowledge: no other node has received the frame";
    case BusError::protocol:
      return "protocol error: a frame was broken on the wire";
    case BusError::transceiver:
      return "transceiver error: check the wires";
    case BusError::recovered:
      return "recovered: the controller is on the bus again";
    case BusError::queue_full:
      return "transmit queue full: no node acknowledges, or too much is sent";
    case BusError::down:
      return "the interface is down";
    case BusError::foreign_master:
      return "another master: another node sends SYNC, NMT or set-points, or uses our number";
    case BusError::other:
      break;
  }
  return "another error of the controller";
}

}  // namespace mrroc::can
