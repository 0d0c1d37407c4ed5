#pragma once

#include <array>

#include "config/deployment.hpp"
#include "mrroc/raw_reading.hpp"
#include "sim/errors/random.hpp"

namespace mrroc::sim {

/// The errors of one simulated sensor's raw readings at time t:
///
///   force/torque (six values):  bias + drift t + normal noise, bias and drift uniform within their sizes
///   ultrasonic, infrared:       normal noise of each range that meets an object
///
/// Readings of other sensors have none. The simulation's thread; allocates nothing, never throws.
class FaultyReadings {
 public:
  /// `period`: s of a tick.
  FaultyReadings(const config::ErrorsEntry& errors, const config::SensorEntry& sensor, double period);

  void apply(RawReading& reading) const noexcept;

 private:
  bool wrench_, range_;
  double period_;
  std::array<double, 6> bias_{}, drift_{}, deviation_{};
  double range_deviation_;
  ErrorNumbers noise_;
};

}  // namespace mrroc::sim
