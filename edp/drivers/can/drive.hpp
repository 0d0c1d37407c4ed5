#pragma once

#include <cstdint>

#include "canopen/drive_state.hpp"
#include "edp/drivers/can/drive_setup.hpp"
#include "edp/drivers/can/mode_display.hpp"
#include "edp/hardware.hpp"
#include "edp/safety/drive_silence.hpp"

namespace mrroc::edp {

/// One CiA 402 drive as its master sees it: what it has said last, what it is to be told next, what is wrong with it.
/// It sends and receives nothing itself, and its time is the servo's tick. Allocates in the constructor only; one
/// thread; never throws.
class Drive {
 public:
  /// What is wrong with it; code none: nothing. Of a silent drive (hardware_silent) the value is a DriveSilence and the
  /// limit the SYNCs in a row that it may leave so. Of one that refuses to be set up again (drive_restarted) the value
  /// is the object, index and sub-index in 24 bits, and the limit its SDO abort code. Of one that answers more often
  /// than it is asked (encoder_fault) the value is in how many cycles, and the limit 0: two nodes have its number. Of a
  /// fault (drive_fault) the value is the error code of its EMCY, 0 without one. Of one that is not ready
  /// (drive_not_ready) the value is its statusword; where it is in another mode, the mode that it shows, and the limit
  /// ours.
  struct Finding {
    ErrorCode code = ErrorCode::none;
    double value = 0;
    double limit = 0;
  };
  /// Set-points of the shaft: A, rad, rad/s.
  struct Target {
    double current = 0;
    double position = 0;
    double velocity = 0;
  };

  /// `period` in s, `home`: rad of the shaft at its zero pulse.
  Drive(const config::DriveTable& table, const config::DriveEntry& entry, double period, double home);

  canopen::NodeId node() const noexcept { return node_; }

  // what comes
  /// Looks at any frame of the bus; true: it was this drive's. `next` is to be sent when it has data.
  bool take(const can::Frame& frame, Tick tick, can::Frame& next) noexcept;
  /// A SYNC is about to be sent.
  void expect() noexcept;
  bool answered() const noexcept { return answered_; }
  /// Whether an answer to this SYNC is to be waited for.
  bool awaited() const noexcept { return !answered_ && speaks(); }
  /// Whether its switches are known: a PDO of them has come since it is in service.
  bool knows_switches() const noexcept { return knows_switches_; }
  /// The time for answers is over: a missing position is guessed from the last two that have come. Where more answers
  /// than SYNCs have come two nodes have its number, and no one knows which is right: as if none had come.
  void close_cycle() noexcept;

  // what it has said
  canopen::DriveState state() const noexcept { return canopen::drive_state(said_.statusword); }
  double position() const noexcept { return static_cast<double>(said_.raw) * rad_per_unit_ + said_.offset; }  ///< rad
  double velocity() const noexcept { return velocity_; }                                                      ///< rad/s
  double current() const noexcept { return said_.current; }                                                   ///< A
  AxisSwitches switches() const noexcept;
  Finding finding(Tick tick) const noexcept;

  // what it is told
  /// It has been set up and started: from `tick` on it answers every SYNC.
  void begin(Tick tick) noexcept;
  void enable(bool on, Tick tick) noexcept;
  /// Clears what has been found and resets its fault, after a stop that is under way; a drive that has restarted is set
  /// up and started again, with `next` as the first request. `position`: where its shaft is, rad, whatever it has said
  /// last; one that counts again continues from there.
  void reset(Tick tick, double position, can::Frame& next) noexcept;
  /// True, and `next` is to be sent: its set-up continues, and the last request has not been answered for kAnswerTime.
  bool repeats(Tick tick, can::Frame& next) noexcept;
  /// True: it is to be asked for its mode, `request` is to be sent.
  bool asks(Tick tick, can::Frame& request) noexcept;
  /// Neither where `enable` nor where `reset` wanted it, and there is still time.
  bool busy(Tick tick) const noexcept;
  /// It is in operation enabled, and in its mode as far as it tells.
  bool is_on() const noexcept;
  /// It keeps its power against its controlword, as one that does not hear it.
  bool defies() const noexcept;
  void home() noexcept;
  Homing homing() const noexcept { return homing_; }
  void add_origin(double shift) noexcept { said_.offset += shift; }
  /// After homing has attained: what to add to its positions.
  double homing_shift() const noexcept { return home_ - said_.offset; }
  /// False: it has restarted, its positions count from there.
  bool knows_position() const noexcept { return !position_lost_; }
  void position_known() noexcept { position_lost_ = false; }
  /// The PDO of this tick.
  can::Frame command(const Target& target) noexcept;
  /// That of a tick in which the robot is being switched on: it holds where it has become on; only with `release` it
  /// goes the last step, in which it lets go of its brake.
  can::Frame hold(bool release) noexcept;
  /// Whether `hold` could be with `release`: only that last step is left, and it is in its mode as far as it tells. One
  /// that shows no mode (0) before it is on is believed.
  bool may_operate() const noexcept;

  DriveSetup& setup() noexcept { return setup_; }

  static constexpr double kAnswerTime = 0.1;  ///< s, to a request of its set-up; then it is sent again
  static constexpr double kObeyTime = 0.5;    ///< s, from the controlword of a stop to its begin
  // of homing, s
  static constexpr double kSelectTime = 0.05;    ///< for the mode's change, of one that does not tell its mode
  static constexpr double kStaleTime = 0.02;     ///< after the start, in which it may still say what was before
  static constexpr double kInstantTime = 0.5;    ///< one that says all that time that it has attained has
  static constexpr double kLongestHoming = 300;  ///< then it has failed

 private:
  /// By its answers.
  struct Said {
    std::uint16_t statusword = 0;
    std::int64_t raw = 0;
    std::int64_t real = 0;        ///< the last position that has come, `raw` where it is not guessed
    std::int64_t since_real = 0;  ///< SYNCs that have been sent since
    std::int64_t increment = 0;   ///< per SYNC
    std::int64_t wraps = 0;       ///< of its 32 bits
    std::int64_t held = 0;        ///< where it has become on
    double offset = 0, current = 0;
    bool known = false;
  };

  void judge(canopen::NmtState state, Tick tick) noexcept;
  std::int64_t unwrapped(std::int64_t raw) noexcept;
  void take_feedback(const can::Frame& frame) noexcept;
  void count_answer() noexcept;
  void take_status(const can::Frame& frame) noexcept;
  void take_position(std::int64_t raw) noexcept;
  void go_on_from(double position) noexcept;
  void follow_homing() noexcept;
  void follow_homing_run() noexcept;
  /// It is, or is to be, in the homing mode.
  bool homes() const noexcept { return homing_ == Homing::running && !homed_; }
  bool mode_is_late(Tick tick) const noexcept;
  /// It is in service and says something, if not always in time.
  bool tells_switches() const noexcept { return without_status_ <= without_status_max_; }
  bool speaks() const noexcept { return running_ && unheard_ <= missed_max_; }
  bool has_power() const noexcept;
  bool still_resetting() const noexcept;
  std::uint16_t controlword(bool release) noexcept;
  can::Frame command_frame(std::uint16_t controlword, double position, double velocity, double torque) const noexcept;

  static constexpr double kPerMille = 1000;

  // from the table
  canopen::NodeId node_;
  canopen::DriveMode mode_;
  double rad_per_unit_, rad_per_velocity_unit_, rated_current_, position_gain_;
  bool absolute_;
  Tick heartbeat_ticks_, switch_on_ticks_, obey_ticks_, answer_ticks_;
  Tick select_ticks_, stale_ticks_, instant_ticks_, homing_ticks_max_;
  int missed_max_;
  int without_status_max_;
  bool reversed_;
  std::int64_t jump_;  ///< units that homing does not move it in a tick
  DrivePdos pdos_;
  DriveSetup setup_;
  ModeDisplay display_;
  double home_;  ///< rad of the shaft where a drive that has homed counts from

  // said
  Said said_;
  Said before_;  ///< what `said_` was before the first answer of this cycle
  double velocity_ = 0;
  std::uint32_t inputs_ = 0;
  std::uint16_t emergency_ = 0;
  bool answered_ = false, running_ = false, restarted_ = false, position_lost_ = false;
  int missed_ = 0;          ///< SYNCs in a row that it has not answered in time
  int without_status_ = 0;  ///< SYNCs since the last PDO of velocity and switches
  bool knows_switches_ = false;
  int owed_ = 0;          ///< answers that may still come
  int surplus_ = 0;       ///< cycles, one after the other, with answers that nothing has asked for
  bool spoke_ = false;    ///< any answer has come in this cycle
  bool unasked_ = false;  ///< one that nothing has asked for
  int unheard_ = 0;       ///< SYNCs in a row without any answer, be it a late one
  Tick heard_ = 0;        ///< its last heartbeat
  Tick begun_ = 0;

  // told
  bool wanted_ = false, was_enabled_ = false, resetting_ = false, pulse_ = false;
  bool waiting_ = false;  ///< for the other drives, before its last step
  Tick since_ = 0;        ///< of `enable` or `reset`
  Tick asked_ = 0;        ///< the last request of its set-up
  Tick stop_ticks_ = 0;   ///< that it has been told to stop and still has power
  Homing homing_ = Homing::none;
  Tick homing_ticks_ = 0;        ///< of its part: the mode's change, the way itself, the change back
  bool homing_started_ = false;  ///< it has the mode, and has been told to start
  bool homing_seen_ = false;     ///< it has said that it has not attained yet
  bool homed_ = false;           ///< it has, and is told its usual mode again
};

}  // namespace mrroc::edp
