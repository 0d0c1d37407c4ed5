#pragma once

#include <vector>

#include "canopen/pdo_mapping.hpp"
#include "canopen/sdo.hpp"
#include "config/drives/drive_table.hpp"

namespace mrroc::edp {

/// A node is lost when its heartbeat has been missing for so many of its periods: theirs to us, and ours to them.
inline constexpr int kMissedHeartbeats = 3;

/// What the PDOs of every drive carry. RPDO 1 goes to a drive in each servo tick, TPDO 1 comes at each SYNC, TPDO 2 at
/// each `status_every`-th one.
struct DrivePdos {
  canopen::PdoMapping command;   ///< RPDO 1: controlword, target, mode
  canopen::PdoMapping feedback;  ///< TPDO 1: statusword, position, torque
  canopen::PdoMapping status;    ///< TPDO 2: velocity, digital inputs
};
DrivePdos drive_pdos(canopen::DriveMode mode);

/// All that is written into a drive before it is started, in this order: its PDOs, heartbeats, the servo period, the
/// mode, quick stop and homing, then the table's own settings. Of what a drive may leave out or have fixed, only what
/// its EDS file has as writable. Throws config::ConfigurationError: a servo period that CiA 402 cannot say.
std::vector<config::DriveSetting> drive_settings(const config::DriveTable& table, const config::DriveEntry& drive,
                                                 double period);

/// Writes the settings into a drive, one after the other, without waiting: its owner sends what it gives and hands it
/// what comes. So a drive that has restarted can be set up while the others are being served. Allocates in the
/// constructor only; never throws.
class DriveSetup {
 public:
  enum class Status : std::uint8_t { idle, writing, done, refused };

  DriveSetup(canopen::NodeId node, std::vector<config::DriveSetting> settings);

  /// Begins again; gives the first request.
  can::Frame start() noexcept;
  /// The same after a look at what the drive still knows of an earlier set-up, the period of its heartbeat.
  can::Frame resume() noexcept;
  /// That look has shown another period: the drive has restarted since. Values that a drive keeps without power (1010h)
  /// look as if it had not.
  bool forgotten() const noexcept { return forgotten_; }
  /// The request under way once more: it was lost, or its answer was. A value of more than four bytes begins again.
  can::Frame again() noexcept { return looks_ ? look() : request(); }
  /// Looks at a frame. True: it was an answer; `next` is to be sent when it has an identifier.
  bool take(const can::Frame& frame, can::Frame& next) noexcept;
  /// Nothing is wanted any more.
  void give_up() noexcept { status_ = Status::idle; }

  Status status() const noexcept { return status_; }
  /// The setting under way, or the one that was refused.
  const config::DriveSetting& setting() const noexcept { return settings_[place_]; }
  canopen::SdoAbort abort() const noexcept { return transfer_.abort(); }

 private:
  can::Frame request() noexcept;
  can::Frame look() noexcept;

  canopen::NodeId node_;
  std::vector<config::DriveSetting> settings_;
  std::size_t place_ = 0;
  Status status_ = Status::idle;
  bool looks_ = false, forgotten_ = false;
  canopen::SdoTransfer transfer_;
};

}  // namespace mrroc::edp
