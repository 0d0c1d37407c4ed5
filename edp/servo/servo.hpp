#pragma once

#include <array>
#include <vector>

#include "edp/check/model_set.hpp"
#include "edp/command/servo_channel.hpp"
#include "edp/force/force_motion.hpp"
#include "edp/force/force_watch.hpp"
#include "edp/hardware.hpp"
#include "edp/safety/current_watch.hpp"
#include "edp/safety/encoder_watch.hpp"
#include "edp/safety/limit_switches.hpp"
#include "edp/safety/motion_watch.hpp"
#include "edp/safety/stop_category.hpp"
#include "edp/servo/drive_homing.hpp"
#include "edp/servo/emergency_latch.hpp"
#include "edp/servo/group_stop.hpp"
#include "edp/servo/regulator.hpp"
#include "edp/servo/servo_state.hpp"
#include "edp/servo/servo_tap.hpp"
#include "edp/servo/synchroniser.hpp"
#include "language/stops/common_stop_path.hpp"
#include "language/stops/stop.hpp"

namespace mrroc::edp {

/// The servo of one robot. One tick: read the hardware, estimate the state, take the set-point of this tick, check
/// the limits, regulate, write the hardware, count. Its owner ticks it: its own thread in real time, the
/// participant in lockstep; the other side of `ServoChannel` may be any single thread. A robot that keeps the time of
/// its servo ticks beside the grid: at x = k + ahead, 0 <= ahead < 1, in ticks. Set-points are those of x, so that they
/// are as smooth as on the grid; all else happens in whole ticks. When the robot's period is the shorter one, a tick k
/// comes twice now and then.
///
/// Set-points: macrosteps one after the other, each from the tick at which its predecessor ended. When a macrostep ends
/// in motion and no successor has come by the next tick, the robot brakes within its limits from its set-point, in step
/// with the other robots of its Move where the command says so, and holds there. At rest it holds the desired position.
/// The robots of a Move stop as a group: where one of them stops alone, for a fault, at a force limit or without a
/// successor, the others brake in step from the next tick on; one that meets its force limit, with them.
///
/// Life (ServoState): it starts stopped, with the drives off. `enable` switches them on at the measured position, so
/// there is no jump, and clears a latched fault; while its cause lasts they stay off. A robot whose drives have lost
/// their positions, but find them on their own (Hardware::homes), is switched on as one that is not synchronised.
/// `disable` and every fault stop the robot, each in its category (stop_category.hpp): faults that the drives report,
/// readings of the encoders that cannot be true, the emergency stop, a limit switch, a current or a following error
/// beyond the axis's limit, a set-point beyond a limit.
///
/// Joints are those of the model in use: the shafts themselves until the hardware is synchronised, the robot's first
/// model then, another one when a macrostep changes it.
///
/// The servo's plan has an epoch: it is left (braking, stopping, switching on, another model) by counting it up, and a
/// macrostep planned for an older epoch is refused, because it would continue a motion that has ended.
///
/// With a force sensor it follows force macrosteps, and watches every motion: a wrench beyond its limits, a sensor that
/// does not answer, a set-point of a force motion from which a stop would not stay inside the limits interrupt the
/// motion. The robot then brakes and holds; the command is returned with a non-fatal error.
///
/// `tick` allocates nothing, takes no lock, does not log, never throws; the constructor allocates.
class Servo {
 public:
  /// `period` in s. `models` and `hardware` must outlive it. Throws SystemError when an axis has no acceleration or
  /// jerk limit.
  Servo(const ModelSet& models, Hardware& hardware, double period, ServoChannel& hand_over);

  /// The robot has a force sensor, which must outlive this object, and stops where it meets more than `limits`. Before
  /// the first tick.
  void use_force_sensor(ForceSensor& sensor, const ForceLimits& limits) noexcept;

  /// The operator's emergency stop, which must outlive this object. Before the first tick.
  void use_emergency_stop(const clock::EmergencyStop& stop) noexcept { emergency_.use(stop); }
  /// The digital input that presses the emergency stop while it is off. Before the first tick.
  void use_emergency_terminal(int terminal) noexcept { emergency_.use_terminal(terminal); }

  /// Of the robots on this computer, of which this is number `robot` of the deployment; must outlive this object.
  /// Before the first tick.
  void use_group_stops(clock::GroupStops& stops, std::size_t robot) noexcept { group_.use(stops, robot); }

  /// A sample of every tick goes to `tap`, which must outlive this object; `waits`: as of SharedRing::claim, under a
  /// simulated clock only. Before the first tick.
  void use_tap(ServoTap& tap, bool waits) noexcept {
    tap_ = &tap;
    tap_waits_ = waits;
  }

  /// Executes tick `tick`, whose readings are of its begin. A gap counts as missed ticks. True: reports have been put
  /// out, the comms side should poll.
  bool tick(Tick tick) noexcept { return this->tick(tick, 0, static_cast<double>(tick)); }
  /// The same at `ahead` of the tick's period, later than the last time; the readings are of the time `measured`,
  /// ticks.
  bool tick(Tick tick, double ahead, double measured) noexcept;

  /// The process ends: from the next tick on the robot stops, then its drives go off, and no order switches them on
  /// again. The servo's thread.
  void leave() noexcept;
  /// Whether the drives wait for each tick (Hardware::waits), so that none may be skipped.
  bool drives_wait() const noexcept { return hardware_.waits(); }
  /// Of the robot, where it keeps the time (Hardware::clock); else null.
  RobotClock* robot_clock() noexcept { return hardware_.clock(); }
  /// False once nothing moves any more: the drives are off, and have reported it. The servo's thread.
  bool drives_on() const noexcept { return has_power(state_) || (leaving_ && hardware_.busy()); }

  /// What the last tick published. The servo's thread.
  const Snapshot& snapshot() const noexcept { return snapshot_; }

 private:
  struct Notice {
    Report::Kind kind;
    std::uint64_t ticket;
    Tick start = 0;
  };
  struct PendingReply {
    std::uint64_t ticket;
    Tick due;
    Tick start;
  };

  bool use(std::uint8_t model) noexcept;
  void widen_limits() noexcept;
  void measure(Tick tick, double measured) noexcept;
  void check_encoders() noexcept;
  void find_fault(const Fault& fault) noexcept;
  bool switch_on() noexcept;
  void give_up_power() noexcept;
  void obey_order(Tick tick) noexcept;
  void watch(Tick tick) noexcept;
  Fault find_in_motion() noexcept;
  void watch_force(Tick tick) noexcept;
  void abort_pending() noexcept;
  void interrupt(const ErrorReport& report, double from, Tick tick) noexcept;
  void count_interruption(const ErrorReport& report) noexcept;
  void give_up_group(Tick tick) noexcept;
  bool moves_in_group() const noexcept;
  bool continues_elsewhere() const noexcept;
  void stop_with_group(Tick tick) noexcept;
  void advance(Tick tick) noexcept;
  void follow(double time, Tick tick) noexcept;
  void follow_force(double now) noexcept;
  bool synchronise(Tick tick) noexcept;
  int synchronised_axis() const noexcept;
  /// The same, where the axis's drive finds its position on its own.
  int homing_axis() const noexcept;
  void change_model() noexcept;
  void use_regulators() noexcept;
  void put_out(const ControllerIo& outputs) noexcept;
  bool start_next(Tick tick) noexcept;
  void refuse_foreign() noexcept;
  void brake(double from) noexcept;
  void brake_in_step(const CommonStop& common) noexcept;
  void brake_with_group() noexcept;
  /// In the reason's category, and from where the robot is if it is hindered (stop_category.hpp).
  void stop(ErrorCode reason, Tick tick) noexcept;
  void stand_where_it_is() noexcept;
  void stop_and_switch_off(Tick tick, ErrorCode reason) noexcept;
  void drives_off(Tick tick) noexcept;
  void latch(const Fault& fault, Tick tick) noexcept;
  bool keeps_limits(Tick tick) noexcept;
  void regulate() noexcept;
  bool publish(Tick tick) noexcept;
  void record(Tick tick) noexcept;

  const ModelSet& models_;
  const RobotModel* model_;
  std::uint8_t model_index_ = 0;
  Hardware& hardware_;
  double period_;
  ServoChannel& channel_;
  Stop stop_;
  CommonStopPath common_stop_;
  GroupStop group_;
  Synchroniser synchroniser_;
  DriveHoming homing_;
  std::vector<Regulator> regulators_;
  std::uint8_t regulator_set_ = 0;
  ControllerIo outputs_;

  // measured
  bool ticked_ = false;  ///< at least once
  Tick last_ = 0;        ///< the last executed tick
  double then_ = 0;      ///< the same, and how far ahead of it, ticks
  double now_ = 0;       ///< of the tick under way
  double elapsed_ = 1;   ///< between these
  HardwareInput input_;
  JointVector joints_, velocity_, measured_motors_, measured_increment_;
  JointVector read_joints_;  ///< those of the last new reading

  // what may stop the robot
  Fault found_;          ///< by the readings of this tick, in every state of the robot
  bool urgent_ = false;  ///< one of them, even if another one is reported
  EncoderWatch encoders_;
  CurrentWatch currents_;
  MotionWatch motion_;
  LimitSwitchWatch switches_;
  EmergencyLatch emergency_;

  // desired
  DesiredState desired_;
  JointVector desired_motors_, previous_position_, previous_motors_;
  JointVector position_min_, position_max_;  ///< widened by where the robot was switched on
  Macrostep active_;
  double origin_ = 0;  ///< when `active_` began: its start, but a stop begins at the set-point before it
  bool running_ = false;
  Tick boundary_ = 0;  ///< tick in which the last macrostep ended
  std::uint64_t finished_ = 0;
  std::uint32_t epoch_ = 0;
  bool braking_ = false;
  bool joined_ = false;
  bool in_step_ = false;  ///< the stop under way is `common_stop_`

  // force
  ForceWatch force_;
  ForceMotion force_motion_;
  bool forced_ = false;    ///< the last macrostep started is one of force
  double force_time_ = 0;  ///< of its last set-point, ticks
  std::uint32_t interruptions_ = 0;
  ErrorReport interruption_;
  ErrorReport postponed_;  ///< interrupts the motion from the next tick on, with the others of its group

  // drives
  std::uint32_t orders_ = 0;  ///< obeyed
  ServoState state_ = ServoState::off;
  bool leaving_ = false;  ///< the process ends
  Fault fault_;
  JointVector current_;

  std::array<PendingReply, 8> pending_{};
  std::size_t pending_count_ = 0;
  std::array<Notice, 16> outbox_{};
  std::size_t outbox_count_ = 0;
  ServoCounters counters_;
  Snapshot snapshot_;
  ServoTap* tap_ = nullptr;
  bool tap_waits_ = false;
};

}  // namespace mrroc::edp
