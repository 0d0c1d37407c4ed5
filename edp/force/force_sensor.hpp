#pragma once

#include "mrroc/errors.hpp"
#include "mrroc/load.hpp"
#include "mrroc/types.hpp"

namespace mrroc::edp {

/// The wrench that the EDP uses in a tick.
struct WrenchReading {
  ErrorCode error = ErrorCode::sensor_not_ready;  ///< none, sensor_not_ready, sensor_out_of_range, sensor_hardware
  /// That the environment exerts on the tool: axes and origin of the sensor frame, N and N m. An estimate when it is
  /// out of range; zero without a reading.
  Wrench wrench = Wrench::Zero();
};

/// The wrist force sensor of one robot, as its servo sees it. The servo's thread; allocates nothing, never throws,
/// never waits.
class ForceSensor {
 public:
  virtual ~ForceSensor() = default;
  /// The sensor frame in the robot's flange frame.
  virtual const Pose& mount() const noexcept = 0;
  /// The reading of `tick`, the flange being at `flange` in the base frame; null: unknown, the robot is not
  /// synchronised.
  virtual WrenchReading read(Tick tick, const Pose* flange) noexcept = 0;
  /// The last reading becomes zero; an out-of-range reading changes nothing.
  virtual void bias() noexcept = 0;
  /// The tool carries `carried` from now on, its centre in the sensor frame: its weight is no part of the wrench.
  virtual void carry(const Load& carried) noexcept = 0;
};

/// Largest wrench that the robot may meet in a motion, N and N m in the axes of the sensor frame: beyond it, it stops.
/// Defaults: the original's.
using ForceLimits = Wrench;

}  // namespace mrroc::edp
