#include "drivers/socketcan/io_setup.hpp"

#include <numeric>

#include "drivers/socketcan/io_pdos.hpp"
#include "drivers/socketcan/setting_list.hpp"

namespace mrroc::edp {

using namespace canopen;

namespace {

constexpr std::int64_t kAllOfBlock = 0xff;

std::uint16_t plus(std::uint16_t index, int number) { return static_cast<std::uint16_t>(index + number - 1); }

void add_pdos(SettingList& list, const config::IoEntry& node, int status_every) {
  const IoPdos pdos(node);
  for (int number = 1; number <= IoPdos::kCount; ++number) {
    const std::uint32_t offset = 0x100u * static_cast<std::uint32_t>(number - 1) + node.node;
    if (pdos.receive(number).size() != 0)
      list.add_pdo(plus(kReceivePdoParameters, number), plus(kReceivePdoMapping, number), kReceivePdo1 + offset,
                   kAtOnce, pdos.receive(number));
    const Object identifier{plus(kTransmitPdoParameters, number), 1};
    if (pdos.transmit(number).size() != 0)
      list.add_pdo(identifier.index, plus(kTransmitPdoMapping, number), kTransmitPdo1 + offset,
                   static_cast<std::uint8_t>(status_every), pdos.transmit(number));
    else
      list.add_known(identifier, kPdoNotUsed | kPdoNoRemote | (kTransmitPdo1 + offset), 4);
  }
  std::vector<std::uint16_t> used(IoPdos::kCount);
  std::iota(used.begin(), used.end(), kTransmitPdoParameters);
  list.switch_off_pdos_but(used);
}

/// The order is that of the profile: the value first, so that its mode never shows another one.
void add_error_values(SettingList& list, const config::IoEntry& node) {
  for (int block = 1; (block - 1) * 8 < node.digital_outputs.count; ++block) {
    const auto sub = static_cast<std::uint8_t>(block);
    list.add_known({kOutputErrorValue, sub}, 0, 1);
    list.add_known({kOutputErrorMode, sub}, kAllOfBlock, 1);
  }
  for (int output = 1; output <= node.analog_outputs.count; ++output) {
    const auto sub = static_cast<std::uint8_t>(output);
    list.add_known({kAnalogOutputErrorValue, sub}, 0, 4);
    list.add_known({kAnalogOutputErrorMode, sub}, 1, 1);
  }
}

}  // namespace

std::vector<config::NodeSetting> io_settings(const config::IoEntry& node, const config::DriveTable& drives) {
  SettingList list(node.node, node.eds, node.settings);
  add_pdos(list, node, drives.status_every);
  list.add_sync(drives.sync);
  list.add_heartbeats(drives.master, drives.heartbeat);
  if (node.analog_inputs.count > 0) list.add_known(kAnalogInterruptEnable, 1, 1);
  add_error_values(list, node);
  return list.take();
}

}  // namespace mrroc::edp
