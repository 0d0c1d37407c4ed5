#pragma once

#include "sensors/entry.hpp"
#include "sensors/force_torque/force_torque_sensor.hpp"

namespace mrroc::vsp {

inline constexpr double kServoPeriod = 0.002;

inline ForceTorqueSensor made_sensor(const std::string& toml = "", const std::string& name = "wrist") {
  ForceTorqueSensor sensor;
  sensor.set_up(entry_of("force_torque", name, toml), kServoPeriod);
  return sensor;
}

/// r when the environment and the tool's weight add up to `load`, which the wrist supports.
inline RawReading raw_of(const Wrench& load, Tick tick = 0) {
  RawReading r;
  r.tick = tick;
  r.count = 6;
  Eigen::Map<Wrench>(r.values.data()) = -load;
  return r;
}

inline SensorReading aggregated(ForceTorqueSensor& sensor, const RawReading& r) {
  SensorReading v;
  v.tick = r.tick;
  v.channel_count = 6;
  sensor.aggregate(r, v);
  return v;
}

inline Wrench wrench_of(const SensorReading& v) { return Eigen::Map<const Wrench>(v.values.data()); }

}  // namespace mrroc::vsp
