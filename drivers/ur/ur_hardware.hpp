#pragma once

#include <memory>

#include "drivers/ur/command.hpp"
#include "drivers/ur/options.hpp"
#include "drivers/ur/robot_start.hpp"
#include "drivers/ur/rtde_link.hpp"
#include "edp/hardware.hpp"
#include "mrroc/robot_model.hpp"

namespace mrroc::ur {

/// An arm of Universal Robots behind its own controller (CB3 and e-Series), which regulates it and follows set-points
/// of its joints:
///
///   RtdeLink    its thread receives the robot's state and sends set-points (RTDE),
///   RobotStart  in real time a thread of its own, makes the robot ready (dashboard server, control script),
///
/// and this class, in the servo thread, exchanges values with both, lock-free. The interface of the drives in the
/// robot's parameters, position or velocity, selects servoj or speedj. With velocity the set-point r of the positions
/// corrects the velocity v by the drives' position_gain: v + position_gain (r - q).
///
/// Positions are the joint angles of the controller; the model converts them to shafts. They are absolute. The
/// controller keeps the time: the servo ticks with its packages (RobotClock), and sends one set-point for each. In a
/// tick without a new package the positions are repeated.
///
/// In lockstep with a stand-in the deployment keeps the time: `read` waits for the package of its tick, and the number
/// of the set-points that `write` sends is that of the tick, plus 1. A stand-in that sends nothing for
/// kLockstepTimeout, or has ended, is the fault `hardware_silent`, until the end of the run.
///
/// `enable(true)` makes the robot ready: it releases a protective stop, switches power on, releases the brakes and
/// starts the control script, which takes seconds. `enable(false)` stops the motion; the controller holds the arm, with
/// its power on. `reset_fault` makes the robot ready, too. The control script stops the robot when this process ends or
/// the connection is cut.
class UrHardware : public edp::Hardware, private edp::RobotClock {
 public:
  /// `model` must outlive it; `period` in s. Throws HardwareError: options that are invalid, a robot that does not have
  /// six axes or whose drives follow currents, a control script that cannot be read.
  UrHardware(const UrOptions& options, const RobotModel& model, double period);
  ~UrHardware() override;

  /// Throws HardwareError that names address, port and problem.
  void open() override;
  void enable(bool on) noexcept override;
  void reset_fault() noexcept override;
  bool busy() const noexcept override;
  edp::RobotClock* clock() noexcept override { return options_.lockstep ? nullptr : this; }
  void read(Tick tick, edp::HardwareInput& input) noexcept override;
  void set_points(const JointVector& position, const JointVector& velocity) noexcept override;
  void write(Tick tick, const JointVector& current) noexcept override;
  void set_outputs(const ControllerIo& outputs) noexcept override;
  void set_origin(const JointVector& shift) noexcept override { origin_ += shift; }

  /// The newest state of the controller. Servo thread.
  const RobotState& state() const noexcept { return state_; }
  LinkCounters link_counters() const noexcept { return link_.counters(); }

 private:
  /// The state of the robot as a drive.
  enum class Phase {
    off,        ///< nothing; the robot holds
    starting,   ///< RobotStart makes it ready
    engaging,   ///< the control script has to confirm that it follows
    following,  ///< it follows the servo's set-points
    stopping,   ///< it has been switched off; the control script stops the motion
    failed      ///< it could not be made ready
  };

  double period() const noexcept override { return 1 / link_.frequency(); }
  bool wait(std::int64_t deadline, edp::Beat& beat) noexcept override;
  edp::BeatCounters counters() const noexcept override { return link_.counters(); }

  void await(Tick tick) noexcept;
  void advance() noexcept;
  void end_start() noexcept;
  UrFault silence(Tick tick) const noexcept;
  UrFault find_fault(Tick tick) const noexcept;
  bool follows() const noexcept;

  const UrOptions options_;
  const RobotModel& model_;
  const double period_;
  const DriveParameters drives_;
  const ControlMode mode_;
  RtdeLink link_;
  const std::unique_ptr<RobotStart> start_;
  RobotState state_;
  bool has_state_ = false;
  bool fresh_ = false;  ///< no tick has read it yet
  bool lost_ = false;   ///< in lockstep: the stand-in has ended, or does not answer
  Phase phase_ = Phase::off;
  bool wanted_ = false;  ///< by the servo: power
  UrFault failure_;
  Tick received_ = 0;     ///< tick in which it was read
  Tick phase_begin_ = 0;  ///< tick since which the control script has to follow, or to stop
  Tick now_ = 0;
  rtde::Vector6d held_{};            ///< joints while the servo does not command yet
  JointVector position_, velocity_;  ///< set-points of the shafts
  JointVector origin_;               ///< added to the shafts
  Command command_;
};

}  // namespace mrroc::ur
