#pragma once

#include <map>
#include <string>
#include <vector>

#include "cli/pictures/hardware_view.hpp"
#include "config/deployment.hpp"
#include "sensors/camera/simulated_view.hpp"
#include "sim/scene/model.hpp"

namespace mrroc::cli {

/// A camera of a deployment.
struct ShownCamera {
  std::string name;           ///< of the sensor
  int width = 0, height = 0;  ///< px
  std::string reason;         ///< why it has no picture; empty: it has one
};

/// The cameras of a deployment: what is needed to draw the pictures of the simulated ones outside the run, and where
/// those of hardware are.
struct CameraViews {
  std::vector<ShownCamera> cameras;                              ///< in the deployment's order
  sim::Model model;                                              ///< of the simulated world; null: there are no views
  std::map<std::string, vsp::SimulatedView, std::less<>> views;  ///< by the names of the simulated ones with pictures
  std::map<std::string, HardwareView, std::less<>> hardware;     ///< by the names of those of hardware with pictures
};

/// Composes the world only if a camera is simulated. `files`: memories of the pictures of hardware cameras, by their
/// names, as the run's status has them. What prevents a camera's picture is its reason and is not thrown. Any thread.
CameraViews camera_views(const config::Deployment& deployment, const std::map<std::string, std::string>& files);

}  // namespace mrroc::cli
