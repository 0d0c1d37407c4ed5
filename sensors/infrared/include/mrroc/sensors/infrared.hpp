#pragma once

#include <string>

#include "mrroc/condition.hpp"
#include "mrroc/message.hpp"
#include "mrroc/sensor.hpp"

namespace mrroc {

/// Configuration of an infrared sensor: it sees what is between `nearest` and `farthest`, m, within the deployment's
/// `dead_zone` and `max_range`, and around its presence.
struct InfraredRange {
  double nearest = 0;
  double farthest = 0;
};
MRROC_MESSAGE(InfraredRange, nearest, farthest)

/// Configuration of an infrared sensor: the presence output switches on at `distance`, m, and off beyond `distance` +
/// `hysteresis`, in place of the deployment's `presence` and `hysteresis`. It is off until the next hardware reading.
struct PresenceAt {
  double distance = 0;
  double hysteresis = 0;
};
MRROC_MESSAGE(PresenceAt, distance, hysteresis)

/// An infrared range sensor of the deployment, type `infrared`: one narrow beam. Something nearer than its dead zone
/// makes the reading an error, which Move and Wait throw (NonFatalError, sensor_out_of_range). Task's thread.
class Infrared : public Sensor {
 public:
  /// Throws NonFatalError when the deployment has no such sensor.
  Infrared(Task& task, const std::string& name);

  /// Distance to the nearest object, m; the sensor's range without one. NaN before the first reading.
  double distance() const noexcept { return value(0); }
  /// Whether anything is seen; false before the first reading.
  bool detected() const noexcept { return value(1) > 0.5; }
  /// The digital output: on from the deployment's `presence`, m, off beyond `presence` + `hysteresis`, between the two
  /// as it was. It is updated at every servo tick. False before the first reading.
  bool presence() const noexcept { return value(2) > 0.5; }
};

/// The presence output is on. `!Presence{sensor}`: it is off.
class Presence : public Condition {
 public:
  explicit Presence(const Infrared& sensor);

 protected:
  bool holds() override { return sensor_->presence(); }

 private:
  const Infrared* sensor_;
};

/// Something is seen nearer than `metres`. A reading that sees nothing is never nearer.
class Nearer : public Condition {
 public:
  /// Throws NonFatalError(invalid_argument) unless `metres` is finite and above 0.
  Nearer(const Infrared& sensor, double metres);

 protected:
  bool holds() override { return sensor_->detected() && sensor_->distance() < metres_; }

 private:
  const Infrared* sensor_;
  double metres_;
};

}  // namespace mrroc
