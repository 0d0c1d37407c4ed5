#include "sensors/digital_input/digital_input_sensor.hpp"

#include <cmath>

#include "vsp/parameters.hpp"

namespace mrroc::vsp {

namespace {

/// Fraction of a tick: tolerance for rounding of a whole number of ticks.
constexpr double kRounding = 1e-6;

}  // namespace

void DigitalInputSensor::configure(const config::SensorEntry& entry, double servo_period) {
  threshold_ = number(entry, "threshold");
  debounce_ = static_cast<Tick>(std::ceil(number(entry, "debounce") / servo_period - kRounding));
}

void DigitalInputSensor::track(const RawReading& r) noexcept {
  const bool now = above(r);
  if (!started_ || now != last_) {
    last_ = now;
    last_since_ = r.tick;
  }
  if (!started_) on_ = now;
  started_ = true;
  if (now == on_ || r.tick - last_since_ < debounce_) return;
  on_ = now;
  if (on_) ++rises_;
}

void DigitalInputSensor::aggregate(const RawReading& r, SensorReading& v) noexcept {
  v.values[0] = on_ ? 1 : 0;
  v.values[1] = rises_;
  v.values[2] = r.values[0];
}

bool DigitalInputSensor::bias(const RawReading& /*r*/) noexcept {
  rises_ = 0;
  return true;
}

}  // namespace mrroc::vsp
