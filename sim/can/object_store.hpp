#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "canopen/eds_file.hpp"
#include "canopen/identifiers.hpp"
#include "canopen/sdo.hpp"

namespace mrroc::sim {

/// The values of a simulated node's object dictionary, as its EDS file describes it: types, access, default values
/// ("$NODEID+0x180" with the node's number). PDOs can be changed only in CiA 301's order (7.5.2.36). One thread.
class ObjectStore {
 public:
  ObjectStore(const canopen::EdsFile& eds, canopen::NodeId node);

  /// Restores all default values, as after power-off.
  void reset();
  /// Those of the communication alone, 1000h to 1FFFh.
  void reset_communication();

  /// Whether PDOs may not be mapped now: the node is operational.
  void lock_mappings(bool locked) noexcept { mappings_locked_ = locked; }

  // access through the bus
  canopen::SdoAbort read(canopen::Object object, std::vector<std::uint8_t>& value) const;
  canopen::SdoAbort write(canopen::Object object, std::span<const std::uint8_t> value);

  // access by the device itself, regardless of access rights; a missing object reads as 0, writes are ignored
  std::int64_t number(canopen::Object object) const;
  void set(canopen::Object object, std::int64_t value);
  /// Bytes of the value.
  std::size_t size(canopen::Object object) const;

 private:
  struct Value {
    const canopen::ObjectEntry* entry;
    std::vector<std::uint8_t> bytes;
  };
  canopen::SdoAbort pdo_refusal(canopen::Object object, std::uint32_t value) const;
  canopen::SdoAbort mapping_refusal(canopen::Object object, std::uint32_t value) const;

  canopen::EdsFile eds_;
  std::map<canopen::Object, Value> defaults_, values_;
  bool mappings_locked_ = false;
};

}  // namespace mrroc::sim
