#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <random>

#include "can/frame.hpp"
#include "canopen/drive_state.hpp"
#include "config/drives/drive_table.hpp"
#include "sim/can/channel.hpp"
#include "sim/can/motor_control.hpp"
#include "sim/can/node_pdo.hpp"
#include "sim/can/object_store.hpp"
#include "sim/can/sdo_server.hpp"

namespace mrroc::sim {

/// A simulated servo drive on a CAN bus: a CANopen node (NMT, SDO, PDOs as they are configured, heartbeats both ways,
/// EMCY) with the drive profile CiA 402 (state machine, cyclic synchronous position, velocity and torque, homing by
/// methods 3, 5, 35 and 37, quick stop); or one axis of a drive with several (`Channel`). It is independent of bus and
/// motor: its owner passes frames and measurements to it, takes its current, and gives the time, ns. One thread.
class DriveNode {
 public:
  using Send = std::function<void(const can::Frame&)>;

  /// `table` and the entry with the drive's number are those of its master; `period` in s.
  DriveNode(const config::DriveTable& table, const config::DriveEntry& entry, const AxisParameters& axis, double period,
            Send send);

  /// Power-on: boot-up message, all values as the manufacturer has set them. Without an absolute encoder it counts from
  /// its shaft's position.
  void boot(std::int64_t now);
  /// Takes any frame of the bus except SYNC.
  void take(const can::Frame& frame, std::int64_t now);
  /// Sends what is due by time alone: heartbeats.
  void update(std::int64_t now);

  // one cycle
  /// The shaft in this cycle, rad and A as measured by its encoder and current sensor.
  void measure(double position, double current, const edp::AxisSwitches& switches);
  /// Takes a SYNC: waiting set-points take effect.
  void synchronise();
  /// The PDOs of this SYNC: that of velocity and switches when it is due, then that of the position.
  void send_status();
  void send_feedback();
  /// Whether the motor still needs a set-point in this cycle.
  bool waits_for_command() const noexcept { return operational() && !commanded_; }
  /// The motor's current until the next cycle, A.
  double drive();

  bool powered() const noexcept;
  bool operational() const noexcept { return nmt_ == canopen::NmtState::operational; }
  canopen::DriveState state() const noexcept { return state_; }
  canopen::NodeId node() const noexcept { return node_; }

  // faults to inject
  /// A drive error: it sends an EMCY, stops, and removes the motor's power.
  void fail(std::uint16_t code);
  /// It sends and receives nothing, as with a cut wire.
  void cut(bool on) noexcept { cut_ = on; }
  /// It sends no heartbeats.
  void hush(bool on) noexcept { hushed_ = on; }
  /// It does not get beyond ready to switch on.
  void hold_back(bool on) noexcept { held_back_ = on; }
  /// Its answer to a SYNC comes only with its set-point: after the master's timeout.
  void lag(bool on) noexcept { lags_ = on; }
  /// It sends no PDO of velocity and switches.
  void withhold_status(bool on) noexcept { withholds_ = on; }
  /// Its positive limit switch is pressed at every position of the axis.
  void press(bool on) noexcept { pressed_ = on; }
  /// It enters operational on its own after booting (1F80h).
  void start_itself(bool on) noexcept { starts_itself_ = on; }
  /// It ignores the next SDO requests, like a drive that is booting.
  void lose_requests(int count) noexcept { deaf_for_ = count; }
  /// It boots after each SDO request that it has answered.
  void boot_at_requests(bool on) noexcept { restless_ = on; }
  /// It stays in this mode against all commands; nothing: it is in the commanded mode.
  void stay_in(std::optional<canopen::DriveMode> mode) noexcept { stays_in_ = mode; }
  /// It reports that its motor does not follow: bit 13 of the statusword in mode cyclic synchronous position.
  void stray(bool on) noexcept { strays_ = on; }
  /// The cause of its fault stays.
  void keep_fault(bool on) noexcept { broken_ = on; }
  /// It repeats the same feedback, regardless of its motion.
  void freeze(bool on) noexcept { frozen_ = on; }
  /// One byte of each frame that it sends is wrong.
  void corrupt(bool on) noexcept { corrupts_ = on; }

 private:
  void send(can::Frame frame);
  void restart(std::int64_t now);
  void reset_communication(std::int64_t now);
  void lose_master();
  void take_request(const can::Frame& frame, std::int64_t now);
  void nmt(canopen::NmtCommand command, std::int64_t now);
  void take_command(const can::Frame& frame);
  void take_mode();
  void obey();
  void follow_state();
  double home();
  void use_pdos();
  double shaft(std::int64_t units) const noexcept;
  std::int64_t units(double shaft) const noexcept;

  canopen::NodeId node_;
  Channel channel_;
  double units_per_rad_, velocity_units_per_rad_, rated_current_;
  bool reversed_, absolute_;
  Send send_;
  ObjectStore store_;
  SdoServer sdo_;
  MotorControl motor_;
  canopen::NmtState nmt_ = canopen::NmtState::boot_up;
  canopen::DriveState state_ = canopen::DriveState::switch_on_disabled;
  std::optional<NodePdo> command_, feedback_, status_;
  can::Frame pending_;  ///< a set-point that waits for the SYNC
  bool has_pending_ = false, commanded_ = false;
  std::uint16_t controlword_ = 0;
  canopen::DriveMode mode_ = canopen::DriveMode::none;  ///< as displayed
  std::int64_t raw_offset_ = 0;                         ///< units; set when its home position is known
  double position_ = 0;
  int syncs_ = 0;
  std::int64_t sent_ = 0, heard_ = 0;  ///< heartbeats, ns; 0: none received yet
  edp::Synchroniser::Status homing_ = edp::Synchroniser::Status::done;
  bool homed_ = false, homing_failed_ = false;
  bool cut_ = false, hushed_ = false, frozen_ = false, held_back_ = false, broken_ = false, lags_ = false,
       owes_ = false, withholds_ = false, pressed_ = false, starts_itself_ = false, restless_ = false,
       corrupts_ = false;
  std::minstd_rand noise_;
  bool strays_ = false;
  std::optional<canopen::DriveMode> stays_in_;
  int deaf_for_ = 0;  ///< SDO requests
  can::Frame last_feedback_;
};

}  // namespace mrroc::sim
