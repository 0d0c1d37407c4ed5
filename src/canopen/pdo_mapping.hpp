#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "can/frame.hpp"
#include "canopen/objects.hpp"

namespace mrroc::canopen {

/// Bits of a PDO's identifier object (sub-index 1 of 1400h.., 1800h..): the PDO is not used; remote frames for it are
/// not allowed (CiA 301, 7.5.2.35 and 37).
inline constexpr std::uint32_t kPdoNotUsed = 0x80000000;
inline constexpr std::uint32_t kPdoNoRemote = 0x40000000;

/// One value in a PDO: the object, and its bytes (whole ones only).
struct MappedObject {
  Object object;
  std::uint8_t size = 0;
  friend bool operator==(const MappedObject&, const MappedObject&) = default;

  /// The form in a mapping object (1600h.., 1A00h..): index, sub-index, bits.
  std::uint32_t entry() const noexcept {
    return static_cast<std::uint32_t>(object.index) << 16 | static_cast<std::uint32_t>(object.sub) << 8 | 8u * size;
  }
  /// Bits that are not whole bytes give size 0.
  static MappedObject of_entry(std::uint32_t entry) noexcept;
};

/// The values in a PDO, one after the other from its first byte (CiA 301, 7.4.4).
class PdoMapping {
 public:
  PdoMapping() = default;
  /// Throws std::invalid_argument: an object without whole bytes, or more than 8 bytes in all.
  explicit PdoMapping(std::vector<MappedObject> objects);

  const std::vector<MappedObject>& objects() const noexcept { return objects_; }
  /// Bytes in use.
  std::size_t size() const noexcept { return size_; }

  /// The value of `object` in a PDO's data, with the sign of its highest bit where `with_sign`. False: it is not
  /// mapped, the frame is too short or of CAN FD. Never throws.
  bool read(const can::Frame& frame, Object object, bool with_sign, std::int64_t& value) const noexcept;
  /// Writes a value; no effect when it is not mapped. Never throws.
  void write(can::Frame& frame, Object object, std::int64_t value) const noexcept;

 private:
  std::vector<MappedObject> objects_;
  std::size_t size_ = 0;
};

}  // namespace mrroc::canopen
