#pragma once

#include <vector>

#include "canopen/pdo_mapping.hpp"
#include "config/drives/drive_table.hpp"

namespace mrroc::edp {

/// The PDO mappings of every drive. RPDO 1 goes to a drive in each servo tick, TPDO 1 comes at each SYNC, TPDO 2 at
/// each `status_every`-th one.
struct DrivePdos {
  canopen::PdoMapping command;   ///< RPDO 1: controlword, target, mode
  canopen::PdoMapping feedback;  ///< TPDO 1: statusword, position, torque
  canopen::PdoMapping status;    ///< TPDO 2: velocity, digital inputs
};
DrivePdos drive_pdos(canopen::DriveMode mode);

/// The settings for one axis written into its drive before it is started, in this order: its PDOs; with those of the
/// first axis of the node what all have in common, heartbeats and the servo period; the mode, quick stop and homing,
/// then the table's own settings. Of optional or constant objects, only those that its EDS
/// file has as writable. Throws config::ConfigurationError for a servo period that CiA 402 cannot express.
std::vector<config::NodeSetting> drive_settings(const config::DriveTable& table, const config::DriveEntry& drive,
                                                double period);

/// The settings of all axes of the node of `drive`, in the axes' order, if it is the first of them; else none.
std::vector<config::NodeSetting> node_settings(const config::DriveTable& table, const config::DriveEntry& drive,
                                               double period);

}  // namespace mrroc::edp
