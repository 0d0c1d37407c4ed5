#pragma once

#include <map>
#include <string>
#include <vector>

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

/// The cameras of a deployment, and what is needed to draw the pictures of the simulated ones outside the run. Cameras
/// of real hardware have none.
struct CameraViews {
  std::vector<ShownCamera> cameras;                              ///< in the deployment's order
  sim::Model model;                                              ///< of the simulated world; null: there are no views
  std::map<std::string, vsp::SimulatedView, std::less<>> views;  ///< by the names of the cameras that have pictures
};

/// Composes the world only if a camera is simulated. What prevents a camera's picture is its reason and is not thrown.
/// Any thread.
CameraViews camera_views(const config::Deployment& deployment);

}  // namespace mrroc::cli
