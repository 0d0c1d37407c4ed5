#include "canopen/pdo_mapping.hpp"

#include <stdexcept>
#include <string>

#include "canopen/object_value.hpp"

namespace mrroc::canopen {

MappedObject MappedObject::of_entry(std::uint32_t entry) noexcept {
  const std::uint32_t bits = entry & 0xff;
  return {{static_cast<std::uint16_t>(entry >> 16), static_cast<std::uint8_t>(entry >> 8)},
          static_cast<std::uint8_t>(bits % 8 == 0 ? bits / 8 : 0)};
}

PdoMapping::PdoMapping(std::vector<MappedObject> objects) : objects_(std::move(objects)) {
  for (const MappedObject& mapped : objects_) {
    if (mapped.size == 0 || mapped.size > 8)
      throw std::invalid_argument("object " + to_text(mapped.object) + ": " + std::to_string(mapped.size) +
                                  " bytes in a PDO, expected 1 to 8");
    size_ += mapped.size;
  }
  if (size_ > can::kMaxClassicalData)
    throw std::invalid_argument(std::to_string(size_) + " bytes in a PDO, expected at most 8");
}

bool PdoMapping::read(const can::Frame& frame, Object object, bool with_sign, std::int64_t& value) const noexcept {
  std::size_t offset = 0;
  for (const MappedObject& mapped : objects_) {
    if (mapped.object == object) {
      if (frame.fd || offset + mapped.size > frame.size) return false;
      const std::uint64_t raw = can::get(frame.bytes(), offset, mapped.size);
      value = with_sign ? can::sign_extended(raw, mapped.size) : static_cast<std::int64_t>(raw);
      return true;
    }
    offset += mapped.size;
  }
  return false;
}

void PdoMapping::write(can::Frame& frame, Object object, std::int64_t value) const noexcept {
  std::size_t offset = 0;
  for (const MappedObject& mapped : objects_) {
    if (mapped.object == object) can::put(frame.data, offset, mapped.size, static_cast<std::uint64_t>(value));
    offset += mapped.size;
  }
  frame.size = static_cast<std::uint8_t>(size_);
}

}  // namespace mrroc::canopen
