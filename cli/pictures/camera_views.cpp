#include "cli/pictures/camera_views.hpp"

#include <exception>

#include "sim/simulation.hpp"

namespace mrroc::cli {

namespace {

void add_simulated(CameraViews& all, const config::Deployment& deployment, const config::SensorEntry& sensor) {
  if (all.model == nullptr) all.model = sim::load_model(sim::compose(deployment));
  all.views.emplace(sensor.name, vsp::view_of(*all.model, sensor));
}

/// Returns why the camera has no pictures here; empty: it has.
std::string add_camera(CameraViews& all, const config::Deployment& deployment, const config::SensorEntry& sensor,
                       const std::map<std::string, std::string>& files) try {
  const auto file = files.find(sensor.name);
  if (sensor.source == "simulated" && deployment.sim) {
    add_simulated(all, deployment, sensor);
  } else if (file != files.end()) {
    all.hardware.try_emplace(sensor.name, sensor, file->second);
  } else {
    return "source = '" + sensor.source + "': " +
           (sensor.host.empty() ? "the run shows no pictures of it" : "its pictures stay on the host " + sensor.host);
  }
  return "";
} catch (const std::exception& error) {
  return error.what();
}

}  // namespace

CameraViews camera_views(const config::Deployment& deployment, const std::map<std::string, std::string>& files) {
  CameraViews all;
  for (const config::SensorEntry& sensor : deployment.sensors) {
    if (!sensor.gives_pictures) continue;
    const std::string reason = add_camera(all, deployment, sensor, files);
    all.cameras.push_back({sensor.name, sensor.picture_width(), sensor.picture_height(), reason});
  }
  return all;
}

}  // namespace mrroc::cli
