#pragma once

#include "sensors/entry.hpp"
#include "sensors/ultrasonic/ultrasonic_sensor.hpp"

namespace mrroc::vsp {

inline UltrasonicSensor made_sensor(const std::string& toml = "", const std::string& name = "gate") {
  UltrasonicSensor sensor;
  sensor.set_up(entry_of("ultrasonic", name, toml), 0.002);
  return sensor;
}

inline SensorReading aggregated(UltrasonicSensor& sensor, double range, Tick tick = 0) {
  RawReading r;
  r.tick = tick;
  r.count = 1;
  r.values[0] = range;
  SensorReading v;
  v.channel_count = 2;
  sensor.aggregate(r, v);
  return v;
}

}  // namespace mrroc::vsp
