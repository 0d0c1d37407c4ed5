#include "drivers/socketcan/setting_list.hpp"

#include <algorithm>
#include <cmath>

#include "canopen/default_value.hpp"
#include "canopen/object_value.hpp"

namespace mrroc::edp {

using namespace canopen;

void SettingList::add(Object object, std::int64_t value, std::uint8_t size) {
  object = of_channel(object, channel_);
  settings_.push_back({object, to_text(object), value, size});
}

void SettingList::add_known(Object object, std::int64_t value, std::uint8_t size) {
  const Object of_axis = of_channel(object, channel_);
  const auto same = [of_axis](const config::NodeSetting& own) { return own.object == of_axis; };
  if (std::any_of(own_.begin(), own_.end(), same)) return;
  const ObjectEntry* const entry = eds_.find(of_axis);
  if (entry != nullptr && entry->writable()) add(object, value, size);
}

void SettingList::add_pdo(std::uint16_t parameters, std::uint16_t mapping, std::uint32_t identifier,
                          std::uint8_t transmission, const PdoMapping& map) {
  if (wants_bit_30({parameters, 1})) identifier |= kPdoNoRemote;
  const ObjectEntry* const entry = eds_.find({parameters, 1});
  const std::int64_t usual = entry != nullptr ? default_number(*entry, node_).value_or(0) : 0;
  const bool changes = usual != 0 && (usual & kPdoNotUsed) == 0 && ((usual ^ identifier) & 0x7ff) != 0;
  if (changes) add({parameters, 1}, kPdoNotUsed | usual, 4);
  add({parameters, 1}, kPdoNotUsed | identifier, 4);
  add({parameters, 2}, transmission, 1);
  add({mapping, 0}, 0, 1);
  std::uint8_t place = 0;
  for (const MappedObject& mapped : map.objects()) {
    const MappedObject of_axis{of_channel(mapped.object, channel_), mapped.size};
    add({mapping, ++place}, of_axis.entry(), 4);
  }
  add({mapping, 0}, place, 1);
  add({parameters, 1}, identifier, 4);
}

void SettingList::switch_off_pdos_but(const std::vector<std::uint16_t>& used) {
  const auto& entries = eds_.entries();
  const auto end = entries.lower_bound({kTransmitPdoMapping, 0});
  for (auto place = entries.lower_bound({kTransmitPdoParameters, 0}); place != end; ++place) {
    const auto& [object, entry] = *place;
    if (object.sub != 1 || std::find(used.begin(), used.end(), object.index) != used.end()) continue;
    // a DCF describes the node after its configuration, which it may not have yet
    for (const auto& identifier : {default_number(entry, node_), configured_number(entry, node_)}) {
      if (!identifier || (*identifier & kPdoNotUsed) != 0) continue;
      add_known(object, kPdoNotUsed | *identifier, 4);
      break;
    }
  }
}

void SettingList::add_sync(std::uint32_t identifier) {
  if (identifier != kSync) add(kSyncIdentifier, identifier, 4);
}

void SettingList::add_heartbeats(NodeId master, double period) {
  const auto milliseconds = static_cast<std::int64_t>(std::lround(period * 1e3));
  add(kConsumerHeartbeat, static_cast<std::int64_t>(master) << 16 | kMissedHeartbeats * milliseconds, 4);
  add(kProducerHeartbeat, milliseconds, 2);
}

std::vector<config::NodeSetting> SettingList::take() const {
  std::vector<config::NodeSetting> all = settings_;
  all.insert(all.end(), own_.begin(), own_.end());
  return all;
}

/// The node sends its transmit PDOs without a request. In receive PDOs the bit is reserved, and some nodes accept only
/// their manufacturer's value.
bool SettingList::wants_bit_30(Object identifier) const {
  if (identifier.index >= kTransmitPdoParameters) return true;
  const ObjectEntry* const entry = eds_.find(identifier);
  return entry != nullptr && (default_number(*entry, node_).value_or(0) & kPdoNoRemote) != 0;
}

}  // namespace mrroc::edp
