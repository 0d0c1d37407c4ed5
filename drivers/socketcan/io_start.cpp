// Prepares an I/O node for its set-up: the terminals of the table are there, PDOs may be changed.
#include "drivers/socketcan/can_hardware.hpp"
#include "drivers/socketcan/repeated_sdo.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::edp {

using namespace canopen;

namespace {

constexpr std::uint32_t kProfile401 = 401;

struct Terminals {
  std::uint16_t index;
  const PdoMapping& mapped;  ///< of one PDO
  const char* kind;
};

/// Part 0 of an array is the number of its parts.
std::string missing_parts(const Terminals& terminals, std::uint64_t there) {
  const std::size_t last = terminals.mapped.objects().empty() ? 0 : terminals.mapped.objects().back().object.sub;
  if (last <= there) return "";
  return "has " + std::to_string(there) + " " + terminals.kind + ", expected " + std::to_string(last);
}

}  // namespace

void CanHardware::prepare_io_node(std::size_t place, SdoClient& client) {
  const NodeId node = node_at(place);
  const IoPdos& pdos = io_node(place).pdos();
  const std::vector<std::uint8_t> type = upload_repeated(client, node, kDeviceType);
  if (can::get(type, 0, 2) != kProfile401)
    fail(ErrorCode::configuration, place,
         "profile " + std::to_string(can::get(type, 0, 2)) + " in its device type, expected 401, an I/O node");
  send(nmt_frame(NmtCommand::enter_pre_operational, node));
  for (int number = 1; number <= IoPdos::kCount; ++number) {
    const bool digital = number == 1;
    for (const Terminals& terminals :
         {Terminals{digital ? kReadInputs : kReadAnalogInputs, pdos.transmit(number),
                    digital ? "blocks of 8 digital inputs (6000h)" : "analogue inputs (6401h)"},
          Terminals{digital ? kWriteOutputs : kWriteAnalogOutputs, pdos.receive(number),
                    digital ? "blocks of 8 digital outputs (6200h)" : "analogue outputs (6411h)"}}) {
      if (terminals.mapped.size() == 0) continue;
      const std::uint64_t there = can::get(upload_repeated(client, node, {terminals.index, 0}), 0, 1);
      if (const std::string missing = missing_parts(terminals, there); !missing.empty())
        fail(ErrorCode::configuration, place, missing);
    }
    if (pdos.receive(number).size() != 0)
      free_pdo(client, node, static_cast<std::uint16_t>(kReceivePdoParameters + number - 1));
    if (pdos.transmit(number).size() != 0)
      free_pdo(client, node, static_cast<std::uint16_t>(kTransmitPdoParameters + number - 1));
  }
}

}  // namespace mrroc::edp
