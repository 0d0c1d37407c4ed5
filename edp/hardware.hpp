#pragma once

#include <array>
#include <cstdint>

#include "edp/robot_clock.hpp"
#include "edp/safety/fault.hpp"
#include "mrroc/errors.hpp"
#include "mrroc/signals.hpp"
#include "mrroc/types.hpp"

namespace mrroc::edp {

/// The switches and the encoder index of one axis in one tick.
struct AxisSwitches {
  bool synchro = false;
  bool lower_limit = false;  ///< the axis is on its limit switch, regardless of the wiring
  bool upper_limit = false;
  bool zero_pulse = false;   ///< a zero pulse has passed since the last reading
  double zero_position = 0;  ///< its position, rad of the shaft as the encoder counts
};

/// The homing state of drives that find their positions on their own.
enum class Homing : std::uint8_t { none, running, attained, failed };

/// The feedback of the drives in one tick.
struct HardwareInput {
  /// When it was measured, ticks of the servo: now, or when the last package of the robot's clock was, unless the
  /// drives report another time. That of the reading before: positions are repeated, extrapolated, or perhaps not new.
  double time = 0;
  double late = 0;                    ///< and how long after it at most, servo periods: on a bus, until it was answered
  std::uint64_t unseen = 0;           ///< set-points of so many ticks before this one had not reached the drives yet
  JointVector motors;                 ///< shaft positions, rad, as the encoders resolve them
  JointVector current;                ///< measured currents, A
  bool synchronised = false;          ///< positions are absolute; else they count from the position at power-on
  ErrorCode fault = ErrorCode::none;  ///< drive_fault, hardware_silent, ... ; `none` when all is well
  int fault_axis = -1;                ///< its axis; -1: the whole robot
  FaultDetail fault_detail{};         ///< its details
  std::array<AxisSwitches, kMaxJoints> switches{};
  ControllerIo inputs;           ///< of the controller's terminals
  Homing homing = Homing::none;  ///< of the axis given to `home`
  double homing_shift = 0;       ///< after homing has attained: the offset to add to its positions, rad
};

/// The drives of one robot: CAN drives, the simulated world, or a plant model. `read` and `write` run in the servo
/// tick: they allocate nothing, take no lock, do not throw, wait no longer than the bus needs.
class Hardware {
 public:
  virtual ~Hardware() = default;
  /// Opens the hardware and waits until it answers. Main thread, before the first tick. Throws HardwareError.
  virtual void open() = 0;
  /// Power to the drives; the drives hold their position (brakes) while disabled.
  virtual void enable(bool on) noexcept = 0;
  /// True: the drives are still executing `enable` or `reset_fault`. This ends on its own, with a fault at worst. Servo
  /// thread, after `read`.
  virtual bool busy() const noexcept { return false; }
  /// Clears faults that the drives have latched. Servo thread.
  virtual void reset_fault() noexcept {}
  /// True: the drives wait for `write` of every tick, so a servo that is late executes each of its ticks; false: they
  /// continue, and it executes the present one only.
  virtual bool waits() const noexcept { return false; }
  /// True: the drives follow the currents of `write`; false: they follow `set_points` and regulate on their own. A
  /// current that no drive follows does not show that an axis is stuck (MotionWatch).
  virtual bool follows_current() const noexcept { return false; }
  /// The clock of a robot that keeps the servo's time; null: it follows the deployment's.
  virtual RobotClock* clock() noexcept { return nullptr; }
  /// Positions at tick `tick`. Values that it does not write stay NaN, and are detected. Servo thread.
  virtual void read(Tick tick, HardwareInput& input) noexcept = 0;
  /// Set-points of the shafts (rad, rad/s) at this tick, for drives that regulate on their own; the others follow the
  /// current alone. Before `write`. Servo thread.
  virtual void set_points(const JointVector& /*position*/, const JointVector& /*velocity*/) noexcept {}
  /// Currents (A) for the coming period, within current_max. Servo thread.
  virtual void write(Tick tick, const JointVector& current) noexcept = 0;
  /// Sets the controller's outputs, with the next `write` at the latest; whether the drives are on does not matter.
  /// Servo thread.
  virtual void set_outputs(const ControllerIo& /*outputs*/) noexcept {}
  /// From now on every shaft position is greater by `shift` (rad), and absolute. Servo thread.
  virtual void set_origin(const JointVector& shift) noexcept = 0;
  /// Whether the drives find their positions on their own, one axis after the other; else the servo does it.
  virtual bool homes() const noexcept { return false; }
  /// Starts homing of this axis: from now on the drive moves it, and `HardwareInput::homing` reports its progress.
  /// Servo thread.
  virtual void home(int /*axis*/) noexcept {}
};

}  // namespace mrroc::edp
