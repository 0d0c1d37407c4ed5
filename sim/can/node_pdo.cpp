#include "sim/can/node_pdo.hpp"

#include <stdexcept>

namespace mrroc::sim {

using namespace canopen;

can::Frame NodePdo::frame(const ObjectStore& store) const {
  can::Frame frame{identifier, {}};
  for (const MappedObject& mapped : mapping.objects()) mapping.write(frame, mapped.object, store.number(mapped.object));
  return frame;
}

bool NodePdo::take(const can::Frame& received, ObjectStore& store) const {
  if (received.size < mapping.size()) return false;
  for (const MappedObject& mapped : mapping.objects()) {
    std::int64_t value = 0;
    if (mapping.read(received, mapped.object, true, value)) store.set(mapped.object, value);
  }
  return true;
}

std::optional<NodePdo> configured_pdo(const ObjectStore& store, std::uint16_t parameters) {
  const auto index = static_cast<std::uint16_t>(parameters + kReceivePdoMapping - kReceivePdoParameters);
  const auto raw = static_cast<std::uint32_t>(store.number({parameters, 1}));
  if ((raw & kPdoNotUsed) != 0 || raw == 0) return {};
  std::vector<MappedObject> objects;
  for (std::int64_t i = 1; i <= store.number({index, 0}); ++i)
    objects.push_back(
        MappedObject::of_entry(static_cast<std::uint32_t>(store.number({index, static_cast<std::uint8_t>(i)}))));
  try {
    return NodePdo{PdoMapping(objects), raw & 0x7ff, static_cast<int>(store.number({parameters, 2}))};
  } catch (const std::invalid_argument&) {
    return {};
  }
}

}  // namespace mrroc::sim
