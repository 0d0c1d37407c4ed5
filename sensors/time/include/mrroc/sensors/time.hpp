#pragma once

#include <string>

#include "mrroc/condition.hpp"
#include "mrroc/sensor.hpp"

namespace mrroc {

/// The deployment's time as a sensor, type `time`: simulated time under lockstep and paced clocks, that of the real
/// clock's grid otherwise, in whole servo ticks. `bias()` makes the present tick zero, as one starts a stop watch.
/// Task's thread.
class Time : public Sensor {
 public:
  /// Throws NonFatalError when the deployment has no such sensor.
  Time(Task& task, const std::string& name);

  /// Since the deployment's tick 0 or the last `bias()`, s. NaN before the first reading.
  double time() const noexcept { return value(0); }
  /// Number of the tick at which the time was read; `bias()` does not change it. 0 before the first reading.
  Tick tick() const noexcept { return reading().channel_count > 1 ? static_cast<Tick>(value(1)) : 0; }
};

/// `Time::time()` is at least `seconds`: the first tick that is not before that moment.
class TimeReached : public Condition {
 public:
  /// Throws NonFatalError(invalid_argument) unless `seconds` is finite.
  TimeReached(const Time& clock, double seconds);

 protected:
  bool holds() override;

 private:
  const Time* clock_;
  double seconds_;
};

}  // namespace mrroc
