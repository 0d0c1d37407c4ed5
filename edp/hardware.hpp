#pragma once

#include <array>

#include "mrroc/errors.hpp"
#include "mrroc/signals.hpp"
#include "mrroc/types.hpp"

namespace mrroc::edp {

/// What one axis's switches and encoder index say in one tick.
struct AxisSwitches {
  bool synchro = false;
  bool lower_limit = false;  ///< the axis stands on its limit switch, whatever that does to the wire
  bool upper_limit = false;
  bool zero_pulse = false;   ///< one has passed since the last reading
  double zero_position = 0;  ///< where, rad of the shaft as the encoder counts
};

/// What the drives report in one tick.
struct HardwareInput {
  Tick tick = 0;                      ///< when it was measured: that of `read`, where the drives say nothing else
  JointVector motors;                 ///< shaft positions, rad, as the encoders resolve them
  JointVector current;                ///< measured currents, A
  bool synchronised = false;          ///< positions are absolute; else they count from where the power came on
  ErrorCode fault = ErrorCode::none;  ///< drive_fault, hardware_silent, ... ; `none` when all is well
  std::array<AxisSwitches, kMaxJoints> switches{};
  Signals inputs;  ///< of the controller's terminals
};

/// The drives of one robot: CAN drives, the simulated world, or a plant model. `read` and `write` run in the servo
/// tick: they allocate nothing, take no lock, do not throw, do not wait longer than the bus needs.
class Hardware {
 public:
  virtual ~Hardware() = default;
  /// Opens the hardware and waits until it answers. Main thread, before the first tick. Throws HardwareError.
  virtual void open() = 0;
  /// Power to the drives; the drives hold their position (brakes) while disabled.
  virtual void enable(bool on) noexcept = 0;
  /// Clears faults that the drives have latched. Servo thread.
  virtual void reset_fault() noexcept {}
  /// True: the drives wait for `write` of every tick, so a servo that is late executes each of its ticks; false: they
  /// go on, and it executes the present one only.
  virtual bool waits() const noexcept { return false; }
  /// Positions at tick `tick`. What it does not write is NaN before, and so found out. Servo thread.
  virtual void read(Tick tick, HardwareInput& input) noexcept = 0;
  /// Currents (A) for the coming period, within current_max. Servo thread.
  virtual void write(Tick tick, const JointVector& current) noexcept = 0;
  /// Sets the controller's outputs, with the next `write` at the latest; whether the drives are on does not matter.
  /// Servo thread.
  virtual void set_outputs(const Signals& /*outputs*/) noexcept {}
  /// From now on every shaft position is greater by `shift` (rad), and absolute. Servo thread.
  virtual void set_origin(const JointVector& shift) noexcept = 0;
};

}  // namespace mrroc::edp
