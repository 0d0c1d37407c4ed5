#pragma once

#include <string>

#include "mrroc/condition.hpp"
#include "mrroc/sensor.hpp"

namespace mrroc {

/// The encoder of a conveyor, type `conveyor_encoder`: its belt as a sensor, for programs that do not drive it.
/// `bias()` makes the present position zero. Task's thread.
class ConveyorEncoder : public Sensor {
 public:
  /// Throws NonFatalError when the deployment has no such sensor.
  ConveyorEncoder(Task& task, const std::string& name);

  /// Travel of the belt since the start or the last `bias()`, m. NaN before the first reading.
  double position() const noexcept { return value(0); }
  /// m/s; NaN before the first reading.
  double velocity() const noexcept { return value(1); }
};

/// The belt is at least `metres` away from where it was when the instruction began, in either direction.
class BeltTravelled : public Condition {
 public:
  /// Throws NonFatalError(invalid_argument) unless `metres` is finite and above 0.
  BeltTravelled(const ConveyorEncoder& encoder, double metres);

  void start() override { origin_ = encoder_->position(); }

 protected:
  bool holds() override;

 private:
  const ConveyorEncoder* encoder_;
  double metres_;
  double origin_ = 0;
};

}  // namespace mrroc
