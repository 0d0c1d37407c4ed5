#pragma once

#include "vsp/noise.hpp"
#include "vsp/virtual_sensor.hpp"

namespace mrroc::vsp {

/// Tracker of six degrees of freedom. r is the target's position (m) and unit quaternion (w, x, y, z); v the same with
/// noise, the quaternion normalised and with w >= 0:
///
///     p' = p + position_noise n        q' = q exp(rotation_noise n')        n, n' normal, per tick
///
/// A quaternion of no length is NonFatalError(sensor_not_ready): the target is not seen.
class TrackerSensor final : public VirtualSensor {
 public:
  void configure(const config::SensorEntry& entry, double servo_period) override;
  void aggregate(const RawReading& r, SensorReading& v) noexcept override;

 private:
  double position_noise_ = 0;
  double rotation_noise_ = 0;
  Noise noise_{""};
};

}  // namespace mrroc::vsp
