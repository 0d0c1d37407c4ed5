#pragma once

#include <cstdint>
#include <vector>

#include "canopen/identifiers.hpp"
#include "canopen/pdo_mapping.hpp"
#include "config/drives/node_objects.hpp"

namespace mrroc::edp {

/// A node is lost when its heartbeat has been missing for so many periods; this applies to the nodes and to us.
inline constexpr int kMissedHeartbeats = 3;

/// Transmission type of a PDO whose values are taken when it comes.
inline constexpr std::uint8_t kAtOnce = 255;

/// Composes the settings of one node in the order in which they are written: those of its master first, then the
/// table's own. At the start; one thread.
class SettingList {
 public:
  /// `eds` and `own`, the table's settings, must outlive it. `channel`: the axis to which objects of the profile
  /// belong; all are given as those of the first one.
  SettingList(canopen::NodeId node, const canopen::EdsFile& eds, const std::vector<config::NodeSetting>& own,
              int channel = 1)
      : node_(node), eds_(eds), own_(own), channel_(channel) {}

  void add(canopen::Object object, std::int64_t value, std::uint8_t size);
  /// Adds the setting if the node has the object, it is writable, and the table does not set it: the table's own value
  /// may be there because the node refuses ours.
  void add_known(canopen::Object object, std::int64_t value, std::uint8_t size);
  /// One PDO: it may be changed only while it is not used (CiA 301, 7.5.2.36).
  void add_pdo(std::uint16_t parameters, std::uint16_t mapping, std::uint32_t identifier, std::uint8_t transmission,
               const canopen::PdoMapping& map);
  /// Switches off the PDOs, except those with the parameters `used`, that the node sends on its own according to its
  /// EDS file: they only fill the bus.
  void switch_off_pdos_but(const std::vector<std::uint16_t>& used);
  /// The SYNC that the node takes; nothing for the predefined one, which every node has.
  void add_sync(std::uint32_t identifier);
  /// The heartbeat of `master` to watch, and the node's own; `period` in s.
  void add_heartbeats(canopen::NodeId master, double period);

  /// All of them, with the table's own at the end.
  std::vector<config::NodeSetting> take() const;

 private:
  bool wants_bit_30(canopen::Object identifier) const;

  canopen::NodeId node_;
  const canopen::EdsFile& eds_;
  const std::vector<config::NodeSetting>& own_;
  int channel_;
  std::vector<config::NodeSetting> settings_;
};

}  // namespace mrroc::edp
