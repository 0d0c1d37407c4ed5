#pragma once

#include "vsp/noise.hpp"
#include "vsp/virtual_sensor.hpp"

namespace mrroc::vsp {

/// Ultrasonic distance sensor: the distance to the nearest thing along one beam, from the sensor's origin. r is one
/// value, m, -1 when nothing is hit (MuJoCo's `rangefinder`). v is `distance` (m) and `detected` (0 or 1):
///
///     nothing hit, beyond max_range, or the echo lost     max_range, 0
///     dead_zone <= r <= max_range                         r + noise, kept within these two, 1
///     0 <= r < dead_zone                                  NonFatalError(sensor_out_of_range)
///     any other negative r                                HardwareError(sensor_hardware)
///
/// An echo is lost with probability `dropout`; whether it is, and the noise, depend on (name, tick) only. It has no
/// zero to set.
class UltrasonicSensor final : public VirtualSensor {
 public:
  std::vector<Channel> channels() const override { return {{"distance", "m"}, {"detected", "0 or 1"}}; }
  std::vector<Channel> raw_channels() const override { return {{"range", "m"}}; }
  void configure(const config::SensorEntry& entry, double servo_period) override;
  void aggregate(const RawReading& r, SensorReading& v) noexcept override;

 private:
  double max_range_ = 0;
  double dead_zone_ = 0;
  double noise_deviation_ = 0;
  double dropout_ = 0;
  Noise noise_{""};
};

}  // namespace mrroc::vsp
