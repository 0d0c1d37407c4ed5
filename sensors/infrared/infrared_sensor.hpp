#pragma once

#include <optional>

#include "mrroc/sensors/infrared.hpp"
#include "vsp/noise.hpp"
#include "vsp/range.hpp"
#include "vsp/virtual_sensor.hpp"

namespace mrroc::vsp {

/// Triangulating infrared range sensor with a narrow beam: the distance along one ray, from the sensor's origin. A lamp
/// throws a spot, a detector at a base line b beside it sees the spot through a lens of focal length f at x = f b / d;
/// an error dx of x is an error dd = d^2 / (f b) dx of the distance, hence the noise. Nearer than `dead_zone` the spot
/// leaves the detector: such a sensor then gives the reading of something farther away, here it is an error.
///
/// r is one value, m, -1 when nothing is hit (MuJoCo's `rangefinder`). v is `distance` d (m), `detected` and `presence`
/// (0 or 1):
///
///     nothing hit, beyond max_range, or the spot lost     max_range, 0, presence off
///     dead_zone <= r <= max_range                         r + noise r^2 n, kept within these two, 1, presence below
///     0 <= r < dead_zone                                  NonFatalError(sensor_out_of_range); the presence stays
///     any other negative r                                HardwareError(sensor_hardware); the presence stays
///
///     presence   on when d <= presence, off when d > presence + hysteresis, between the two as it was; off at the
///     start
///
/// n is normal with deviation 1. n and whether the spot is lost (probability `dropout`) depend on (name, tick) only.
/// The presence is updated at every tick, with or without requests for readings. It has no zero to set.
class InfraredSensor final : public VirtualSensor {
 public:
  void configure(const config::SensorEntry& entry, double servo_period) override;
  bool continuous() const noexcept override { return true; }
  void track(const RawReading& r) noexcept override;
  void aggregate(const RawReading& r, SensorReading& v) noexcept override;
  /// `InfraredRange`, `PresenceAt` (mrroc/sensors/infrared.hpp).
  void reconfigure(const Message& configuration) override;

 private:
  void apply(const InfraredRange& range);
  void apply(const PresenceAt& presence);
  bool measurable(double range) const noexcept { return range >= dead_zone_ || range == kNothingHit; }
  /// Distance of a measurable r; nothing when nothing is seen.
  std::optional<double> seen(const RawReading& r) const noexcept;

  static constexpr double kNothingHit = -1;
  Range hardware_;  ///< of the deployment
  double max_range_ = 0;
  double dead_zone_ = 0;
  double noise_growth_ = 0;  ///< 1/m
  double dropout_ = 0;
  double on_at_ = 0;       ///< m
  double off_beyond_ = 0;  ///< m
  bool presence_ = false;
  Noise noise_{""};
};

}  // namespace mrroc::vsp
