#pragma once

#include <string>

#include "config/scratch.hpp"
#include "config/sensor_type.hpp"

namespace mrroc::vsp {

/// The entry that a deployment file gives for a sensor `name` of `type` on robot `arm` with the keys in `toml`: its own
/// parameters are checked against the type's declarations, defaults filled in.
inline config::SensorEntry entry_of(const std::string& type, const std::string& name, const std::string& toml = "") {
  const config::Scratch scratch;
  config::SensorEntry entry;
  entry.name = name;
  entry.type = type;
  entry.robot = "arm";
  config::read_sensor_type(config::Table::load(scratch.write("sensor.toml", toml)), entry);
  return entry;
}

/// The channels that sensors/<type>/<type>.toml declares, as "name unit" each.
inline std::vector<std::string> declared_channels(const std::string& type) {
  std::vector<std::string> declared;
  const auto file = std::filesystem::path{MRROC_SOURCE_DIR} / "sensors" / type / (type + ".toml");
  for (const config::Table& channel : config::Table::load(file).tables("channels")) {
    declared.push_back(channel.text("name") + " " + channel.text("unit"));
    channel.finish();
  }
  return declared;
}

}  // namespace mrroc::vsp
