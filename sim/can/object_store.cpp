#include "sim/can/object_store.hpp"

#include <algorithm>
#include <cstdlib>

#include "can/frame.hpp"

namespace mrroc::sim {

using namespace canopen;

namespace {

bool is_mapping(std::uint16_t index) noexcept {
  constexpr std::uint16_t kMappings = 0x200;  // of 512 PDOs in each direction
  return (index >= kReceivePdoMapping && index < kReceivePdoMapping + kMappings) ||
         (index >= kTransmitPdoMapping && index < kTransmitPdoMapping + kMappings);
}

}  // namespace

ObjectStore::ObjectStore(const EdsFile& eds, NodeId node) : eds_(eds), node_(node) { reset(); }

std::vector<std::uint8_t> ObjectStore::default_of(const ObjectEntry& entry) const {
  if (entry.type == DataType::visible_string) return {entry.default_value.begin(), entry.default_value.end()};
  std::vector<std::uint8_t> bytes(size_of(entry.type));
  std::string text = entry.default_value;
  std::int64_t value = 0;
  constexpr std::string_view kOwn = "$NODEID";
  if (text.starts_with(kOwn)) {
    value = node_;
    text = text.substr(kOwn.size());
    if (text.starts_with("+")) text = text.substr(1);
  }
  value = static_cast<std::int64_t>(static_cast<std::uint64_t>(value) +
                                    static_cast<std::uint64_t>(std::strtoll(text.c_str(), nullptr, 0)));
  can::put(bytes, 0, bytes.size(), static_cast<std::uint64_t>(value));
  return bytes;
}

void ObjectStore::reset() {
  values_.clear();
  for (const auto& [object, entry] : eds_.entries()) values_[object] = {&entry, default_of(entry)};
}

void ObjectStore::reset_communication() {
  for (auto& [object, value] : values_)
    if (object.index >= 0x1000 && object.index < 0x2000) value.bytes = default_of(*value.entry);
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

SdoAbort ObjectStore::write(Object object, std::span<const std::uint8_t> value) {
  std::vector<std::uint8_t> before;
  const auto found = values_.find(object);
  if (found == values_.end()) return read(object, before);
  if (!found->second.entry->writable()) return SdoAbort::read_only;
  if (mappings_locked_ && is_mapping(object.index)) return SdoAbort::wrong_state;
  if (found->second.bytes.size() != value.size()) return SdoAbort::wrong_length;
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
