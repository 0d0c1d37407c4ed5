#pragma once

#include "sensors/entry.hpp"
#include "sensors/tracker/tracker_sensor.hpp"

namespace mrroc::vsp {

inline TrackerSensor made_sensor(const std::string& toml = "") {
  TrackerSensor sensor;
  sensor.set_up(entry_of("tracker", "tracker", toml), 0.002);
  return sensor;
}

inline RawReading raw(const Eigen::Vector3d& p, const Eigen::Quaterniond& q, Tick tick = 0) {
  RawReading r;
  r.tick = tick;
  r.count = 7;
  r.values[0] = p.x(), r.values[1] = p.y(), r.values[2] = p.z();
  r.values[3] = q.w(), r.values[4] = q.x(), r.values[5] = q.y(), r.values[6] = q.z();
  return r;
}

inline SensorReading aggregated(TrackerSensor& sensor, const RawReading& r) {
  SensorReading v;
  v.channel_count = 7;
  sensor.aggregate(r, v);
  return v;
}

}  // namespace mrroc::vsp
