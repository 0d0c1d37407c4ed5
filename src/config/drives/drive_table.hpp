#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "canopen/drive_state.hpp"
#include "canopen/eds_file.hpp"
#include "canopen/identifiers.hpp"
#include "config/drives/node_objects.hpp"
#include "mrroc/robot_parameters.hpp"

namespace mrroc::config {

/// Homing of a drive (CiA 402-2, homing mode).
struct DriveHoming {
  std::int8_t method = 0;   ///< 0: no homing
  double speed_switch = 0;  ///< rad/s of the shaft
  double speed_zero = 0;    ///< rad/s of the shaft
};

/// One axis's drive.
struct DriveEntry {
  std::string axis;
  canopen::NodeId node = 0;
  int channel = 1;              ///< which axis of a drive with several, from 1
  int first_pdo = 1;            ///< number of the axis's first RPDO and TPDO
  canopen::NodeId pdos_of = 0;  ///< the node number whose predefined identifiers its PDOs have; 0: `node`
  double units_per_turn = 0;    ///< position units (6064h) per revolution of the shaft; below 0: reversed
  /// Velocity units (606Ch, 60FFh, 6099h) per revolution per second, with the same sign.
  double velocity_units_per_turn = 0;
  double rated_current = 0;  ///< A: 1000 per mille of torque (6071h, 6077h)
  double position_gain = 0;  ///< 1/s, cyclic velocity: speed per rad of position error
  DriveHoming homing;
  std::vector<NodeSetting> settings;  ///< in the order of the file, those of all drives first

  canopen::NodeId pdo_node() const noexcept { return pdos_of != 0 ? pdos_of : node; }
};

/// The drives of a robot on a CAN bus, one per axis in the axes' order: robots/<type>/<type>_drives.toml or a local
/// file. docs/how-to/can.md explains every key.
struct DriveTable {
  std::filesystem::path file;
  canopen::DriveMode mode = canopen::DriveMode::cyclic_position;
  bool absolute_encoders = false;  ///< positions are absolute from the start; otherwise the robot must be synchronised
  canopen::NodeId master = 127;    ///< whose heartbeats the drives watch: ours
  std::uint32_t sync = canopen::kSync;  ///< identifier of our SYNC; distinct for each robot on one bus
  double heartbeat = 0.1;               ///< s between two heartbeats of each node; it is lost after three times that
  double answer_time = 0.5;             ///< of the servo period: the drives' maximum time to answer a SYNC
  int missed_max = 2;                   ///< consecutive SYNCs that a drive may leave unanswered
  double switch_on_time = 2.0;          ///< s for a drive to switch on, off, or reset
  bool target_at_sync = true;           ///< the drives apply a set-point at the next SYNC, else at once
  int status_every = 4;                 ///< SYNCs between two PDOs of velocity and switches
  std::vector<DriveEntry> drives;
  canopen::EdsFile eds;  ///< a drive's object dictionary

  /// The drives of the node of `drive` begin with this one, in the axes' order.
  bool is_first_of_node(const DriveEntry& drive) const noexcept;
  /// Nodes: drives with several axes count once.
  std::size_t nodes() const noexcept;
};

/// Reads a table for a robot with these axes. Throws ConfigurationError: an error in it or in the EDS file that it
/// names; an axis without a drive or with two; two drives with one node and channel, or one PDO; a node that is the
/// master's; an impossible rated current or resolution; an object that is not in the EDS file, is read-only or is
/// written by the EDP itself.
DriveTable read_drive_table(const std::filesystem::path& file, const RobotParameters& robot);

}  // namespace mrroc::config
