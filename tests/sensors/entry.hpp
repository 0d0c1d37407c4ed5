#pragma once

#include <string>

#include "config/entries/sensor_type.hpp"
#include "mrroc/testing/scratch_folder.hpp"

namespace mrroc::vsp {

/// The entry of a sensor `name` of `type` on robot `arm` in a deployment file with the keys in `toml`: its own
/// parameters are checked against the type's declarations, and defaults are filled in.
inline config::SensorEntry entry_of(const std::string& type, const std::string& name, const std::string& toml = "") {
  const task_test::ScratchFolder scratch;
  config::SensorEntry entry;
  entry.name = name;
  entry.type = type;
  entry.robot = "arm";
  config::read_sensor_type(config::Table::load(scratch.write("sensor.toml", toml)), entry);
  return entry;
}

}  // namespace mrroc::vsp
