#pragma once

#include <cstdint>

#include "canopen/drive_state.hpp"
#include "drivers/socketcan/drive_answers.hpp"
#include "drivers/socketcan/drive_fault.hpp"
#include "drivers/socketcan/drive_position.hpp"
#include "drivers/socketcan/drive_power.hpp"
#include "drivers/socketcan/drive_setup.hpp"
#include "drivers/socketcan/homing_run.hpp"
#include "drivers/socketcan/mode_display.hpp"
#include "drivers/socketcan/node_setup.hpp"
#include "edp/hardware.hpp"

namespace mrroc::edp {

/// One CiA 402 drive, or one axis of a drive with several, as its master sees it: the position of its shaft
/// (DrivePosition), its answers to the SYNCs (DriveAnswers), its power (DrivePower), its homing (HomingRun) and its
/// faults. It does no I/O: its owner passes the frames in both directions. Time is the servo's tick. Allocates in the
/// constructor only; one thread; never throws.
class Drive {
 public:
  /// Set-points of the shaft: A, rad, rad/s.
  struct Target {
    double current = 0;
    double position = 0;
    double velocity = 0;
  };

  static constexpr double kAnswerTime = 0.1;  ///< s, to a request of the set-up; then it is sent again

  /// `period` in s, `home`: rad of the shaft at its zero pulse.
  Drive(const config::DriveTable& table, const config::DriveEntry& entry, double period, double home);

  canopen::NodeId node() const noexcept { return node_; }
  /// The node number whose predefined identifiers its PDOs have.
  canopen::NodeId pdo_node() const noexcept { return pdo_node_; }
  /// Which axis of its node, from 1.
  int channel() const noexcept { return channel_; }
  /// The first of the axes of its node: it writes the settings of all, and starts it.
  bool leads() const noexcept { return leads_; }

  // ---- received
  /// Takes any frame of the bus; true: it is from this drive. `next` is to be sent unless it is empty.
  bool take(const can::Frame& frame, Tick tick, can::Frame& next) noexcept;
  /// A SYNC is about to be sent.
  void expect() noexcept;
  bool answered() const noexcept { return answers_.answered(); }
  /// An answer to this SYNC is still expected.
  bool awaited() const noexcept { return !answered() && answers_.is_alive(); }
  /// A TPDO 2 with the switches has been received since the drive is in service.
  bool knows_switches() const noexcept { return answers_.knows_switches(); }
  /// The time for answers has passed: a missing position is extrapolated. When more answers than SYNCs have arrived,
  /// all of this cycle are discarded.
  void close_cycle() noexcept;

  // ---- state
  canopen::DriveState state() const noexcept { return canopen::drive_state(feedback_.statusword); }
  double position() const noexcept { return position_.position(); }  ///< rad
  double velocity() const noexcept { return velocity_; }             ///< rad/s
  double current() const noexcept { return feedback_.current; }      ///< A
  AxisSwitches switches() const noexcept;
  DriveFault fault(Tick tick) const noexcept;
  /// It reports a fault in its own state.
  bool has_error() const noexcept {
    return state() == canopen::DriveState::fault || state() == canopen::DriveState::fault_reaction_active;
  }

  // ---- commands
  /// The drive has been set up and started: from `tick` on it answers every SYNC.
  void begin(Tick tick) noexcept;
  void enable(bool on, Tick tick) noexcept;
  /// Answers arrive, and its switches are reported.
  bool serves() const noexcept { return answers_.is_alive() && answers_.reports_switches(); }
  /// Clears the faults and resets those of the drive, after a stop under way. `again`: the node has restarted; the
  /// drive that leads sets it up and starts it again, with `next` as the first request. `position`: of the shaft, rad;
  /// a relative counter continues from there.
  void reset(Tick tick, double position, bool again, can::Frame& next) noexcept;
  /// True: the set-up is under way and its last request has not been answered within kAnswerTime; `next` is to be sent.
  bool repeats(Tick tick, can::Frame& next) noexcept;
  /// True: `request` asks for the mode display and is to be sent.
  bool asks(Tick tick, can::Frame& request) noexcept;
  /// An answer to such a request is awaited. A node takes one request at a time.
  bool awaits_mode(Tick tick) const noexcept { return display_.waits(tick); }
  /// The last `enable` or `reset` is not done, and there is still time.
  bool busy(Tick tick) const noexcept;
  /// Operation enabled, in the commanded mode as far as the drive reports it.
  bool is_on() const noexcept;
  /// The drive keeps its power against its controlword.
  bool ignores_controlword() const noexcept { return answers_.in_service() && power_.ignores_controlword(state()); }
  void home() noexcept { homing_.begin(display_); }
  Homing homing() const noexcept { return homing_.homing(); }
  void add_origin(double shift) noexcept { position_.add_origin(shift); }
  /// After homing has attained: the shift of the positions, rad.
  double homing_shift() const noexcept { return home_ - position_.offset(); }
  /// False: the drive has restarted, and its positions are relative to that.
  bool knows_position() const noexcept { return !position_.lost(); }
  void lose_position() noexcept { position_.lose(); }
  void position_known() noexcept { position_.found(); }
  /// The RPDO of this tick.
  can::Frame command(const Target& target) noexcept;
  /// The RPDO of a tick in which the robot is being switched on: the drive holds its position. `release`: it may take
  /// the last step, in which it releases its brake.
  can::Frame hold(bool release) noexcept;
  /// Only the last step remains, in the commanded mode as far as the drive reports it. A mode display of 0 before that
  /// step is accepted.
  bool may_operate() const noexcept;

  NodeSetup& setup() noexcept { return setup_; }

 private:
  /// Of the last TPDO 1, beside the position.
  struct Feedback {
    std::uint16_t statusword = 0;
    double current = 0;
  };

  void judge(canopen::NmtState state, Tick tick) noexcept;
  void take_feedback(const can::Frame& frame) noexcept;
  void take_status(const can::Frame& frame) noexcept;
  void take_emergency(std::uint16_t code, Tick tick) noexcept;
  void take_heartbeat(const can::Frame& frame, Tick tick, can::Frame& next) noexcept;
  void take_response(const can::Frame& frame, Tick tick, can::Frame& next) noexcept;
  bool mode_is_late(Tick tick) const noexcept;
  bool reset_is_done() const noexcept;
  std::uint16_t controlword(bool release) noexcept;
  can::Frame command_frame(std::uint16_t controlword, double position, double velocity, double torque) const noexcept;

  static constexpr double kPerMille = 1000;
  /// Ticks after which an EMCY is a fault of every axis of its node: those that have it report it by then.
  static constexpr Tick kEmergencyTicks = 10;

  // from the table
  canopen::NodeId node_, pdo_node_;
  int channel_;
  bool leads_, shares_node_;
  canopen::DriveMode mode_;
  double rad_per_velocity_unit_, rated_current_, position_gain_;
  Tick heartbeat_ticks_, answer_ticks_;
  bool reversed_;
  double home_;  ///< rad of the shaft at the origin of a drive that has homed
  DrivePdos pdos_;

  NodeSetup setup_;
  ModeDisplay display_;
  DrivePosition position_;
  DriveAnswers answers_;
  DrivePower power_;
  HomingRun homing_;

  Feedback feedback_, saved_;  ///< saved before the first answer of this cycle
  double velocity_ = 0;
  std::uint32_t inputs_ = 0;
  std::uint16_t emergency_ = 0;
  Tick emergency_at_ = 0;
  bool restarted_ = false;
  Tick heard_ = 0;  ///< the last heartbeat
  Tick begun_ = 0;
  Tick asked_ = 0;  ///< the last request of the set-up
};

}  // namespace mrroc::edp
