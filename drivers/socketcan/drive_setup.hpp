#pragma once

#include <vector>

#include "canopen/pdo_mapping.hpp"
#include "canopen/sdo.hpp"
#include "config/drives/drive_table.hpp"

namespace mrroc::edp {

/// A node is lost when its heartbeat has been missing for so many periods; this applies to the drives and to us.
inline constexpr int kMissedHeartbeats = 3;

/// The PDO mappings of every drive. RPDO 1 goes to a drive in each servo tick, TPDO 1 comes at each SYNC, TPDO 2 at
/// each `status_every`-th one.
struct DrivePdos {
  canopen::PdoMapping command;   ///< RPDO 1: controlword, target, mode
  canopen::PdoMapping feedback;  ///< TPDO 1: statusword, position, torque
  canopen::PdoMapping status;    ///< TPDO 2: velocity, digital inputs
};
DrivePdos drive_pdos(canopen::DriveMode mode);

/// The settings written into a drive before it is started, in this order: its PDOs, heartbeats, the servo period, the
/// mode, quick stop and homing, then the table's own settings. Of optional or constant objects, only those that its EDS
/// file has as writable. Throws config::ConfigurationError for a servo period that CiA 402 cannot express.
std::vector<config::DriveSetting> drive_settings(const config::DriveTable& table, const config::DriveEntry& drive,
                                                 double period);

/// Writes the settings into a drive, one after the other, without waiting: its owner sends the requests and passes the
/// answers to it. So a drive that has restarted can be set up during normal operation of the others. Allocates in the
/// constructor only; never throws.
class DriveSetup {
 public:
  enum class Status : std::uint8_t { idle, writing, done, refused };

  DriveSetup(canopen::NodeId node, std::vector<config::DriveSetting> settings);

  /// Begins again; returns the first request.
  can::Frame start() noexcept;
  /// The same, but first reads whether the drive still has an earlier set-up: the period of its heartbeat.
  can::Frame resume() noexcept;
  /// The read period differs: the drive has restarted since. Without this check, values that a drive stores without
  /// power (1010h) would hide the restart.
  bool forgotten() const noexcept { return forgotten_; }
  /// The request under way once more: it was lost, or its answer was. A value of more than four bytes begins again.
  can::Frame again() noexcept { return looks_ ? poll() : request(); }
  /// Takes a frame. True: it was an answer; `next` is to be sent when it has an identifier.
  bool take(const can::Frame& frame, can::Frame& next) noexcept;
  /// Stops the set-up.
  void give_up() noexcept { status_ = Status::idle; }

  Status status() const noexcept { return status_; }
  /// The present setting, or the rejected one.
  const config::DriveSetting& setting() const noexcept { return settings_[place_]; }
  canopen::SdoAbort abort() const noexcept { return transfer_.abort(); }

 private:
  can::Frame request() noexcept;
  can::Frame poll() noexcept;

  canopen::NodeId node_;
  std::vector<config::DriveSetting> settings_;
  std::size_t place_ = 0;
  Status status_ = Status::idle;
  bool looks_ = false, forgotten_ = false;
  canopen::SdoTransfer transfer_;
};

}  // namespace mrroc::edp
