#include "canopen/emergency.hpp"

#include <algorithm>

namespace mrroc::canopen {

namespace {

struct EmergencyText {
  std::uint16_t code;
  std::string_view text;
};

// CiA 301 table 26 and CiA 402-2 5.3; a group ends with zeros
constexpr EmergencyText kEmergencyTexts[] = {
    {0x0000, "no error"},
    {0x1000, "generic error"},
    {0x2000, "current"},
    {0x2100, "current on the device's input side"},
    {0x2200, "current inside the device"},
    {0x2300, "current on the device's output side"},
    {0x2310, "continuous over-current"},
    {0x2320, "short circuit or earth leakage"},
    {0x2330, "earth leakage"},
    {0x2340, "short circuit"},
    {0x3000, "voltage"},
    {0x3100, "mains voltage"},
    {0x3110, "mains over-voltage"},
    {0x3120, "mains under-voltage"},
    {0x3130, "a phase is missing"},
    {0x3200, "voltage inside the device"},
    {0x3210, "DC link over-voltage"},
    {0x3220, "DC link under-voltage"},
    {0x3300, "output voltage"},
    {0x4000, "temperature"},
    {0x4100, "ambient temperature"},
    {0x4200, "device temperature"},
    {0x4210, "excess device temperature"},
    {0x4300, "drive temperature"},
    {0x4310, "excess drive temperature"},
    {0x5000, "device hardware"},
    {0x5100, "supply"},
    {0x5112, "24 V supply under-voltage"},
    {0x5400, "power section"},
    {0x5530, "data memory"},
    {0x6000, "device software"},
    {0x6100, "internal software"},
    {0x6200, "user software"},
    {0x6300, "data set"},
    {0x6320, "parameter error"},
    {0x7000, "additional modules"},
    {0x7100, "power module"},
    {0x7110, "brake chopper"},
    {0x7120, "motor"},
    {0x7121, "motor blocked"},
    {0x7122, "motor error or commutation malfunction"},
    {0x7300, "sensor"},
    {0x7305, "incremental sensor 1 fault"},
    {0x7306, "incremental sensor 2 fault"},
    {0x7310, "speed"},
    {0x7320, "position"},
    {0x7500, "communication module"},
    {0x8000, "monitoring"},
    {0x8100, "communication"},
    {0x8110, "CAN overrun (objects lost)"},
    {0x8120, "CAN in error passive mode"},
    {0x8130, "life guard or heartbeat error"},
    {0x8140, "recovered from bus off"},
    {0x8150, "identifier collision"},
    {0x8200, "protocol error"},
    {0x8210, "PDO not processed: length error"},
    {0x8220, "PDO length exceeded"},
    {0x8250, "RPDO timeout"},
    {0x8300, "torque control"},
    {0x8311, "excess torque"},
    {0x8400, "velocity control"},
    {0x8480, "speed following error"},
    {0x8500, "position control"},
    {0x8600, "positioning controller"},
    {0x8611, "position following error"},
    {0x8612, "reference limit"},
    {0x8700, "sync controller"},
    {0x8800, "winding controller"},
    {0x9000, "external error"},
    {0xf000, "additional functions"},
    {0xff00, "a manufacturer's error"},
};

std::string_view exact(std::uint16_t code) noexcept {
  const auto* const found =
      std::lower_bound(std::begin(kEmergencyTexts), std::end(kEmergencyTexts), code,
                       [](const EmergencyText& text, std::uint16_t wanted) { return text.code < wanted; });
  return found != std::end(kEmergencyTexts) && found->code == code ? found->text : std::string_view{};
}

}  // namespace

std::optional<Emergency> emergency_of(const can::Frame& frame) noexcept {
  if (frame.error || frame.remote || frame.fd || frame.size != 8) return {};
  if (frame.id <= kEmergency || frame.id > kEmergency + kMaxNode) return {};
  Emergency emergency{static_cast<NodeId>(frame.id - kEmergency),
                      static_cast<std::uint16_t>(can::get(frame.bytes(), 0, 2)),
                      frame.data[2],
                      {}};
  std::copy_n(frame.data.begin() + 3, emergency.manufacturer.size(), emergency.manufacturer.begin());
  return emergency;
}

can::Frame to_frame(const Emergency& emergency) {
  can::Frame frame{kEmergency + emergency.node, {0, 0, emergency.error_register, 0, 0, 0, 0, 0}};
  can::put(frame.data, 0, 2, emergency.code);
  std::copy(emergency.manufacturer.begin(), emergency.manufacturer.end(), frame.data.begin() + 3);
  return frame;
}

std::string_view error_text(std::uint16_t code) noexcept {
  for (const unsigned mask : {0xffffu, 0xfff0u, 0xff00u, 0xf000u}) {
    if ((code & mask) == 0 && code > 0xff) break;  // 00xxh alone is not an error
    if (const std::string_view text = exact(static_cast<std::uint16_t>(code & mask)); !text.empty()) return text;
  }
  return "unknown error";
}

}  // namespace mrroc::canopen
