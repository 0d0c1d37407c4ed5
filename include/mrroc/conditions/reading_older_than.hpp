#pragma once

#include "mrroc/condition.hpp"
#include "mrroc/sensor.hpp"

namespace mrroc {

/// The last reading of a sensor was measured more than `seconds` ago (`Sensor::age()`), or there is no reading yet.
/// Limits how long a task continues without a new reading of a polled or non-interactive sensor.
class ReadingOlderThan : public Condition {
 public:
  /// Throws NonFatalError(invalid_argument) unless `seconds` is finite and not negative.
  ReadingOlderThan(const Sensor& sensor, double seconds);

 protected:
  bool holds() override { return sensor_->age() > seconds_; }

 private:
  const Sensor* sensor_;
  double seconds_;
};

}  // namespace mrroc
