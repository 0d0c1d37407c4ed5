#include "cli/pictures/camera_views.hpp"

#include <exception>

#include "sim/simulation.hpp"

namespace mrroc::cli {

namespace {

/// Sensor types that view the simulated world have this key.
bool is_camera(const config::SensorEntry& sensor) { return sensor.texts.contains("camera"); }

/// Why the pictures of this camera are out of reach; empty: they are drawn.
std::string obstacle_of(const config::Deployment& deployment, const config::SensorEntry& sensor) {
  if (sensor.source == "simulated" && deployment.sim) return "";
  return "source = '" + sensor.source + "': only simulated cameras have pictures here";
}

int whole_or_zero(const config::SensorEntry& sensor, const char* key) {
  const auto found = sensor.numbers.find(key);
  return found == sensor.numbers.end() || found->second.empty() ? 0 : static_cast<int>(found->second.front());
}

}  // namespace

CameraViews camera_views(const config::Deployment& deployment) {
  CameraViews all;
  for (const config::SensorEntry& sensor : deployment.sensors) {
    if (!is_camera(sensor)) continue;
    ShownCamera& camera = all.cameras.emplace_back(ShownCamera{
        sensor.name, whole_or_zero(sensor, "width"), whole_or_zero(sensor, "height"), obstacle_of(deployment, sensor)});
    if (!camera.reason.empty()) continue;
    try {
      if (all.model == nullptr) all.model = sim::load_model(sim::compose(deployment));
      all.views.emplace(sensor.name, vsp::view_of(*all.model, sensor));
    } catch (const std::exception& error) {
      camera.reason = error.what();
    }
  }
  return all;
}

}  // namespace mrroc::cli
