#include "sim/can/object_store.hpp"

#include <algorithm>

#include "can/frame.hpp"
#include "canopen/default_value.hpp"
#include "canopen/pdo_mapping.hpp"

namespace mrroc::sim {

using namespace canopen;

namespace {

constexpr std::uint16_t kPdos = 0x200;  // in each direction
constexpr std::uint32_t kIdentifier = 0x3fffffff;
constexpr std::uint32_t kMostBits = 64;

bool is_parameter(std::uint16_t index) noexcept {
  return (index >= kReceivePdoParameters && index < kReceivePdoParameters + kPdos) ||
         (index >= kTransmitPdoParameters && index < kTransmitPdoParameters + kPdos);
}

bool is_mapping(std::uint16_t index) noexcept { return is_parameter(static_cast<std::uint16_t>(index - kPdos)); }

}  // namespace

ObjectStore::ObjectStore(const EdsFile& eds, NodeId node) : eds_(eds) {
  for (const auto& [object, entry] : eds_.entries()) defaults_[object] = {&entry, configured_bytes(entry, node)};
  reset();
}

void ObjectStore::reset() { values_ = defaults_; }

void ObjectStore::reset_communication() {
  for (auto& [object, value] : values_)
    if (object.index >= 0x1000 && object.index < 0x2000) value.bytes = defaults_.at(object).bytes;
}

SdoAbort ObjectStore::read(Object object, std::vector<std::uint8_t>& value) const {
  const auto found = values_.find(object);
  if (found == values_.end()) {
    const auto index = values_.lower_bound(Object{object.index, 0});
    return index != values_.end() && index->first.index == object.index ? SdoAbort::no_such_sub_index
                                                                        : SdoAbort::no_such_object;
  }
  if (!found->second.entry->readable()) return SdoAbort::write_only;
  value = found->second.bytes;
  return SdoAbort::none;
}

/// A PDO's identifier and mapping stay while it is used.
SdoAbort ObjectStore::pdo_refusal(Object object, std::uint32_t value) const {
  const auto used = [this](std::uint16_t parameters) { return (number({parameters, 1}) & kPdoNotUsed) == 0; };
  if (is_parameter(object.index) && object.sub == 1) {
    const bool other = ((static_cast<std::uint32_t>(number(object)) ^ value) & kIdentifier) != 0;
    return other && used(object.index) ? SdoAbort::invalid_value : SdoAbort::none;
  }
  if (!is_mapping(object.index)) return SdoAbort::none;
  if (used(static_cast<std::uint16_t>(object.index - kPdos))) return SdoAbort::wrong_state;
  return mapping_refusal(object, value);
}

/// Objects are mapped while sub-index 0 is 0, then it gives their number.
SdoAbort ObjectStore::mapping_refusal(Object object, std::uint32_t value) const {
  if (object.sub == 0) {
    if (value > kMostBits) return SdoAbort::mapping_too_long;  // even of objects of a bit each
    std::int64_t bits = 0;
    for (std::uint32_t i = 1; i <= value; ++i) bits += number({object.index, static_cast<std::uint8_t>(i)}) & 0xff;
    return bits > kMostBits ? SdoAbort::mapping_too_long : SdoAbort::none;
  }
  if (number({object.index, 0}) != 0) return SdoAbort::unsupported_access;
  if (value == 0) return SdoAbort::none;
  const auto mapped = values_.find(MappedObject::of_entry(value).object);
  if (mapped == values_.end()) return SdoAbort::not_mappable;
  const ObjectEntry& entry = *mapped->second.entry;
  const bool received = object.index < kTransmitPdoMapping;
  const bool fits =
      entry.mappable && size_of(entry.type) * 8 == (value & 0xff) && (received ? entry.writable() : entry.readable());
  return fits ? SdoAbort::none : SdoAbort::not_mappable;
}

SdoAbort ObjectStore::write(Object object, std::span<const std::uint8_t> value) {
  std::vector<std::uint8_t> before;
  const auto found = values_.find(object);
  if (found == values_.end()) return read(object, before);
  if (!found->second.entry->writable()) return SdoAbort::read_only;
  if (mappings_locked_ && is_mapping(object.index)) return SdoAbort::wrong_state;
  if (found->second.bytes.size() != value.size()) return SdoAbort::wrong_length;
  const auto number = static_cast<std::uint32_t>(can::get(value, 0, std::min<std::size_t>(4, value.size())));
  if (const SdoAbort why = pdo_refusal(object, number); why != SdoAbort::none) return why;
  found->second.bytes.assign(value.begin(), value.end());
  return SdoAbort::none;
}

std::int64_t ObjectStore::number(Object object) const {
  const auto found = values_.find(object);
  if (found == values_.end()) return 0;
  const std::vector<std::uint8_t>& bytes = found->second.bytes;
  if (bytes.empty() || bytes.size() > 8) return 0;
  const std::uint64_t raw = can::get(bytes, 0, bytes.size());
  return is_signed(found->second.entry->type) ? can::sign_extended(raw, bytes.size()) : static_cast<std::int64_t>(raw);
}

void ObjectStore::set(Object object, std::int64_t value) {
  const auto found = values_.find(object);
  if (found == values_.end()) return;
  can::put(found->second.bytes, 0, std::min<std::size_t>(8, found->second.bytes.size()),
           static_cast<std::uint64_t>(value));
}

std::size_t ObjectStore::size(Object object) const {
  const auto found = values_.find(object);
  return found == values_.end() ? 0 : found->second.bytes.size();
}

}  // namespace mrroc::sim
