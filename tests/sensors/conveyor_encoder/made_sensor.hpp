#pragma once

#include "sensors/conveyor_encoder/conveyor_encoder_sensor.hpp"
#include "sensors/entry.hpp"

namespace mrroc::vsp {

inline ConveyorEncoderSensor made_sensor(const std::string& toml = "") {
  ConveyorEncoderSensor sensor;
  sensor.set_up(entry_of("conveyor_encoder", "encoder", toml), 0.002);
  return sensor;
}

inline RawReading raw(double travel, double speed = 0) {
  RawReading r;
  r.count = 2;
  r.values[0] = travel;
  r.values[1] = speed;
  return r;
}

inline SensorReading aggregated(ConveyorEncoderSensor& sensor, const RawReading& r) {
  SensorReading v;
  v.channel_count = 2;
  sensor.aggregate(r, v);
  return v;
}

}  // namespace mrroc::vsp
