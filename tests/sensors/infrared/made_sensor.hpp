#pragma once

#include "sensors/entry.hpp"
#include "sensors/infrared/infrared_sensor.hpp"

namespace mrroc::vsp {

inline InfraredSensor made_sensor(const std::string& toml = "", const std::string& name = "eye") {
  InfraredSensor sensor;
  sensor.set_up(entry_of("infrared", name, toml), 0.002);
  return sensor;
}

inline RawReading raw(double range, Tick tick = 0) {
  RawReading r;
  r.tick = tick;
  r.count = 1;
  r.values[0] = range;
  return r;
}

inline SensorReading aggregated(InfraredSensor& sensor, double range, Tick tick = 0) {
  SensorReading v;
  v.channel_count = 3;
  sensor.aggregate(raw(range, tick), v);
  return v;
}

}  // namespace mrroc::vsp
