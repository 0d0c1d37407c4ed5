#pragma once

#include "sensors/ultrasonic/beam.hpp"
#include "vsp/noise.hpp"
#include "vsp/range.hpp"
#include "vsp/virtual_sensor.hpp"

namespace mrroc::vsp {

/// Ultrasonic distance sensor: the distance from the sensor's origin to the nearest object in its beam that sends the
/// sound back. r is one range per ray of the beam, m, -1 when the ray hits nothing (MuJoCo's `rangefinder`): one ray on
/// the axis, `range`, or the fan `range_0` ... of `rays` rays over `beam_angle`. With e = nearest_echo(r) (beam.hpp; of
/// one ray its range), v is `distance` (m) and `detected` (0 or 1):
///
///     no echo, beyond max_range, or the echo lost         max_range, 0
///     dead_zone <= e <= max_range                         e + noise, kept within these two, 1
///     0 <= e < dead_zone                                  NonFatalError(sensor_out_of_range)
///     any negative range except -1                         HardwareError(sensor_hardware)
///
/// An echo is lost with probability `dropout`; whether it is, and the noise, depend on (name, tick) only. It has no
/// zero to set.
class UltrasonicSensor final : public VirtualSensor {
 public:
  /// `range`, or `range_0` ... when the deployment gives more rays than one: after `configure()`.
  std::vector<Channel> raw_channels() const override;
  void configure(const config::SensorEntry& entry, double servo_period) override;
  void aggregate(const RawReading& r, SensorReading& v) noexcept override;
  /// `UltrasonicRange` (mrroc/sensors/ultrasonic.hpp): dead_zone and max_range.
  void reconfigure(const Message& configuration) override;

 private:
  void configure_beam(const config::SensorEntry& entry);

  std::size_t rays_ = 1;
  Beam beam_;
  Range hardware_;  ///< of the deployment
  double max_range_ = 0;
  double dead_zone_ = 0;
  double noise_deviation_ = 0;
  double dropout_ = 0;
  Noise noise_{""};
};

}  // namespace mrroc::vsp
