#pragma once

#include "sensors/entry.hpp"
#include "sensors/time/time_sensor.hpp"
#include "sensors/time/time_source.hpp"

namespace mrroc::vsp {

inline TimeSensor made_sensor(double servo_period = 0.002) {
  TimeSensor sensor;
  sensor.set_up(entry_of("time", "watch"), servo_period);
  return sensor;
}

/// r of the clock itself.
inline RawReading raw(Tick tick) {
  TimeSource source;
  RawReading r;
  source.read(tick, r);
  return r;
}

inline SensorReading aggregated(TimeSensor& sensor, Tick tick) {
  SensorReading v;
  v.channel_count = 2;
  sensor.aggregate(raw(tick), v);
  return v;
}

}  // namespace mrroc::vsp
