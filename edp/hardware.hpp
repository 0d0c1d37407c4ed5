#pragma once

#include "mrroc/errors.hpp"
#include "mrroc/types.hpp"

namespace mrroc::edp {

/// What the drives report in one tick.
struct HardwareInput {
  JointVector motors;                 ///< shaft positions, rad, as the encoders resolve them
  JointVector current;                ///< measured currents, A
  bool synchronised = false;          ///< positions are absolute
  ErrorCode fault = ErrorCode::none;  ///< drive_fault, hardware_silent, ... ; `none` when all is well
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
  /// Positions at tick `tick`. Servo thread.
  virtual void read(Tick tick, HardwareInput& input) noexcept = 0;
  /// Currents (A) for the coming period, within current_max. Servo thread.
  virtual void write(Tick tick, const JointVector& current) noexcept = 0;
};

}  // namespace mrroc::edp
