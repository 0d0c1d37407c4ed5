#pragma once

#include "sensors/entry.hpp"
#include "sensors/operator_input/operator_input_sensor.hpp"

namespace mrroc::vsp {

/// Replayed: it has no operator.
inline OperatorInputSensor made_sensor(const std::string& toml = "") {
  OperatorInputSensor sensor;
  sensor.set_up(entry_of("operator_input", "parts", toml), 0.002);
  return sensor;
}

inline RawReading raw(double answers, double value) {
  RawReading r;
  r.count = 2;
  r.values[0] = answers;
  r.values[1] = value;
  return r;
}

inline SensorReading aggregated(OperatorInputSensor& sensor, const RawReading& r) {
  SensorReading v;
  v.channel_count = 2;
  sensor.aggregate(r, v);
  return v;
}

}  // namespace mrroc::vsp
