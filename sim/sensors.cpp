#include "sim/sensors.hpp"

#include "config/table.hpp"

namespace mrroc::sim {

namespace {

std::string all_sensors(const mjModel& model) {
  std::string list;
  for (int i = 0; i < model.nsensor; ++i) {
    const std::string name = model.names + model.name_sensoradr[i];
    if (!name.empty()) list += (list.empty() ? "" : ", ") + name;
  }
  return list.empty() ? "none" : list;
}

}  // namespace

SensorSource::SensorSource(const mjModel& model, const std::string& name, const std::string& type,
                           const std::string& robot) {
  const bool found =
      take(model, name) || (!robot.empty() && (take(model, robot + "/" + name) || take(model, robot + "/" + type)));
  const std::string key = "sensors." + name;
  if (!found) {
    const std::string in_robot =
        robot.empty() ? "" : ", \"" + robot + "/" + name + "\" or \"" + robot + "/" + type + "\"";
    throw config::ConfigurationError({}, 0, key, "the simulated world has no sensor of this name",
                                     "\"" + name + "\"" + in_robot + " among those that exist: " + all_sensors(model));
  }
  if (addresses_.size() > kMaxRawValues) {
    throw config::ConfigurationError({}, 0, key, std::to_string(addresses_.size()) + " values",
                                     "at most " + std::to_string(kMaxRawValues));
  }
}

bool SensorSource::take(const mjModel& model, const std::string& prefix) {
  bool found = false;
  for (int i = 0; i < model.nsensor; ++i) {
    const std::string name = model.names + model.name_sensoradr[i];
    if (name != prefix && !name.starts_with(prefix + "/")) continue;
    found = true;
    for (int k = 0; k < model.sensor_dim[i]; ++k) addresses_.push_back(model.sensor_adr[i] + k);
  }
  return found;
}

void SensorSource::read(const mjData& data, RawReading& reading) const noexcept {
  reading.count = static_cast<std::uint32_t>(addresses_.size());
  for (std::size_t i = 0; i < addresses_.size(); ++i) reading.values[i] = data.sensordata[addresses_[i]];
}

}  // namespace mrroc::sim
