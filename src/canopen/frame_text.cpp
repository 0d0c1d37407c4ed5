#include "canopen/frame_text.hpp"

#include <cstdio>

#include "can/bus_error.hpp"
#include "canopen/emergency.hpp"
#include "canopen/identifiers.hpp"
#include "canopen/object_value.hpp"
#include "canopen/sdo.hpp"

namespace mrroc::canopen {

namespace {

std::string bytes_of(std::span<const std::uint8_t> bytes) { return to_text(bytes, DataType::octet_string); }

std::string nmt_text(const can::Frame& frame) {
  if (frame.size != 2) return "NMT of " + std::to_string(frame.size) + " bytes";
  const std::string whom = frame.data[1] == 0 ? "all nodes" : "node " + std::to_string(frame.data[1]);
  return "NMT " + whom + ": " + std::string(describe(static_cast<NmtCommand>(frame.data[0])));
}

std::string emergency_text(const can::Frame& frame) {
  const auto emergency = emergency_of(frame);
  if (!emergency) return "emergency of " + std::to_string(frame.size) + " bytes: " + bytes_of(frame.bytes());
  char code[8];
  std::snprintf(code, sizeof code, "%04Xh", emergency->code);
  return "emergency " + std::string(code) + ": " + std::string(error_text(emergency->code)) + ", register " +
         bytes_of(frame.bytes().subspan(2, 1)) + ", maker's " + bytes_of(frame.bytes().subspan(3));
}

std::string sdo_text(const can::Frame& frame, bool request) {
  const std::string name = request ? "SDO request" : "SDO answer";
  if (frame.size != 8) return name + " of " + std::to_string(frame.size) + " bytes: " + bytes_of(frame.bytes());
  const unsigned specifier = frame.data[0] >> 5;
  const std::string object = to_text(Object{static_cast<std::uint16_t>(can::get(frame.bytes(), 1, 2)), frame.data[3]});
  const bool expedited = (frame.data[0] & 2) != 0;
  const std::size_t size = (frame.data[0] & 1) != 0 ? 4u - ((frame.data[0] >> 2) & 3u) : 4u;
  const bool size_told = (frame.data[0] & 1) != 0;
  const std::string value = expedited   ? " = " + bytes_of(frame.bytes().subspan(4, size))
                            : size_told ? ", " + std::to_string(can::get(frame.bytes(), 4, 4)) + " bytes"
                                        : ", in segments";
  if (specifier == 4)
    return "SDO abort " + object + ": " + std::string(describe(static_cast<SdoAbort>(can::get(frame.bytes(), 4, 4))));
  if (specifier == 1 && request) return "SDO write " + object + value;
  if (specifier == 2) return request ? "SDO read " + object : "SDO value " + object + value;
  if (specifier == 3 && !request) return "SDO written " + object;
  return name + " segment: " + bytes_of(frame.bytes());
}

std::string of_node(const can::Frame& frame, std::uint32_t function) {
  const std::string data = frame.size == 0 ? "" : ": " + bytes_of(frame.bytes());
  switch (function) {
    case kEmergency:
      return emergency_text(frame);
    case kSdoResponse:
      return sdo_text(frame, false);
    case kSdoRequest:
      return sdo_text(frame, true);
    case kHeartbeat:
      return frame.size == 1 ? "heartbeat: " + std::string(describe(static_cast<NmtState>(frame.data[0] & 0x7f)))
                             : "heartbeat of " + std::to_string(frame.size) + " bytes" + data;
    default:
      break;
  }
  const std::uint32_t number = (function - kTransmitPdo1) / 0x100 + 1;
  return ((function - kTransmitPdo1) % 0x100 == 0 ? "TPDO " : "RPDO ") + std::to_string(number) + data;
}

}  // namespace

std::string to_text(const can::Frame& frame) {
  if (frame.error) return std::string("bus: ") + can::describe(can::bus_error_of(frame));
  char id[8];
  std::snprintf(id, sizeof id, "%03Xh", frame.id & 0x7ff);
  if (frame.fd) return "CAN FD " + std::string(id) + ": " + bytes_of(frame.bytes());
  const NodeId node = frame.id & 0x7f;
  const std::uint32_t function = frame.id & 0x780;
  const bool of_a_node = node != 0 && ((function >= kEmergency && function <= kSdoRequest) || function == kHeartbeat) &&
                         !(function == kTime && node != 0);
  if (frame.remote) return "request for " + to_text(Object{static_cast<std::uint16_t>(frame.id)}).substr(1, 4);
  if (frame.id == kNmt) return nmt_text(frame);
  if (frame.id == kSync) return "SYNC";
  // of one of several masters: an EMCY has data
  if (frame.id > kSync && frame.id <= kLastSync && frame.size == 0 && !frame.remote) return "SYNC " + std::string(id);
  if (frame.id == kTime) return "TIME: " + bytes_of(frame.bytes());
  if (of_a_node) return "node " + std::to_string(node) + " " + of_node(frame, function);
  return std::string(id) + ": " + bytes_of(frame.bytes());
}

}  // namespace mrroc::canopen
