#pragma once

#include <string>

#include "mrroc/condition.hpp"
#include "mrroc/message.hpp"
#include "mrroc/sensor.hpp"

namespace mrroc {

/// Configuration of an ultrasonic sensor: it sees what is between `nearest` and `farthest`, m, within the deployment's
/// `dead_zone` and `max_range`. Something nearer than `nearest` makes the reading an error, as in the dead zone.
struct UltrasonicRange {
  double nearest = 0;
  double farthest = 0;
};
MRROC_MESSAGE(UltrasonicRange, nearest, farthest)

/// An ultrasonic distance sensor of the deployment, type `ultrasonic`. Task's thread.
class Ultrasonic : public Sensor {
 public:
  /// Throws NonFatalError when the deployment has no such sensor.
  Ultrasonic(Task& task, const std::string& name);

  /// Distance to the nearest object, m; the sensor's range without one. NaN before the first reading.
  double distance() const noexcept { return value(0); }
  /// Whether anything is seen; false before the first reading.
  bool detected() const noexcept { return value(1) > 0.5; }
};

/// Something is seen nearer than `metres`. A reading that sees nothing is never closer.
class Closer : public Condition {
 public:
  /// Throws NonFatalError(invalid_argument) unless `metres` is finite and above 0.
  Closer(const Ultrasonic& sensor, double metres);

 protected:
  bool holds() override { return sensor_->detected() && sensor_->distance() < metres_; }

 private:
  const Ultrasonic* sensor_;
  double metres_;
};

}  // namespace mrroc
