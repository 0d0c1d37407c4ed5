// The objects of each axis of a drive with several.
#include <utility>

#include "canopen/eds_file.hpp"

namespace mrroc::canopen {

namespace {

constexpr std::uint16_t kPdoBlock = 0x200;

bool is_pdo_parameter(Object object) {
  return (object.index >= kReceivePdoParameters && object.index < kReceivePdoMapping) ||
         (object.index >= kTransmitPdoParameters && object.index < kTransmitPdoMapping);
}

/// Of the profile, or of the first two PDOs in one direction.
bool is_of_first_axis(Object object) {
  if (is_of_profile(object)) return object.index < kProfile + kObjectsOfChannel;
  return object.index >= kReceivePdoParameters && object.index < kTransmitPdoMapping + kPdoBlock &&
         object.index % kPdoBlock < 2;
}

Object on_axis(Object object, int channel, int first_pdo) {
  if (is_of_profile(object)) return of_channel(object, channel);
  return {static_cast<std::uint16_t>(object.index + first_pdo - 1), object.sub};
}

}  // namespace

void EdsFile::repeat_axis(int channel, int first_pdo) {
  std::map<Object, ObjectEntry> copies;
  for (const auto& [object, entry] : entries_) {
    if (!is_of_first_axis(object)) continue;
    ObjectEntry copy = entry;
    const bool is_identifier = object.sub == 1 && is_pdo_parameter(object);
    if (is_identifier) copy.default_value = copy.parameter_value = "0x80000000";  // not used
    copies.emplace(on_axis(object, channel, first_pdo), std::move(copy));
  }
  entries_.merge(copies);
}

EdsFile EdsFile::of_axis(int channel, int first_pdo) const {
  EdsFile axis = *this;
  for (auto& [object, entry] : axis.entries_)
    if (is_of_first_axis(object))
      if (const ObjectEntry* const own = find(on_axis(object, channel, first_pdo))) entry = *own;
  return axis;
}

}  // namespace mrroc::canopen
