#pragma once

#include "sensors/digital_input/digital_input_sensor.hpp"
#include "sensors/entry.hpp"

namespace mrroc::vsp {

/// The servo period is 2 ms.
inline DigitalInputSensor made_sensor(const std::string& toml = "") {
  DigitalInputSensor sensor;
  sensor.set_up(entry_of("digital_input", "gate", toml), 0.002);
  return sensor;
}

inline RawReading raw(Tick tick, double level) {
  RawReading r;
  r.tick = tick;
  r.count = 1;
  r.values[0] = level;
  return r;
}

/// The reading at `tick` when the sensor is woken for it.
inline SensorReading measured(DigitalInputSensor& sensor, Tick tick, double level) {
  SensorReading v;
  v.channel_count = 3;
  sensor.track(raw(tick, level));
  sensor.aggregate(raw(tick, level), v);
  return v;
}

}  // namespace mrroc::vsp
