#pragma once

#include <cstdint>
#include <string>

#include "mrroc/condition.hpp"
#include "mrroc/sensor.hpp"

namespace mrroc {

/// A digital or analogue terminal as a sensor, type `digital_input`: of the world, or of a robot's controller for a
/// program that does not own the robot. (`DigitalInput{robot, i}` is the condition of a program that does: its robot's
/// state has the terminals.) `bias()` sets the count of rises to zero. Task's thread.
class DigitalSensor : public Sensor {
 public:
  /// Throws NonFatalError when the deployment has no such sensor.
  DigitalSensor(Task& task, const std::string& name);

  /// Debounced; false before the first reading.
  bool on() const noexcept { return value(0) > 0.5; }
  /// The number of changes from off to on since the start or the last `bias()`, rises between readings included; 0
  /// before the first reading.
  std::uint64_t rises() const noexcept { return value(1) > 0 ? static_cast<std::uint64_t>(value(1)) : 0; }
  /// Of the terminal, in its own unit, not debounced. NaN before the first reading.
  double level() const noexcept { return value(2); }
};

/// The terminal is on; `!On{gate}` for off.
class On : public Condition {
 public:
  explicit On(const DigitalSensor& input) : Condition(input.name() + " on"), input_(&input) {}

 protected:
  bool holds() override { return input_->on(); }

 private:
  const DigitalSensor* input_;
};

/// The terminal has gone from off to on since the instruction began, even for a moment (except for the debouncing).
class Risen : public Condition {
 public:
  explicit Risen(const DigitalSensor& input) : Condition(input.name() + " risen"), input_(&input) {}

  void start() override { origin_ = input_->rises(); }

 protected:
  bool holds() override;

 private:
  const DigitalSensor* input_;
  std::uint64_t origin_ = 0;
};

}  // namespace mrroc
