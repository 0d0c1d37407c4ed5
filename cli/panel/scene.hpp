#pragma once

#include <mujoco/mujoco.h>

#include <span>
#include <string>

#include "cli/panel/camera_pictures.hpp"
#include "config/deployment.hpp"

namespace mrroc::cli {

/// The composed world as a JSON object for the panel's page: bodies, their geometry and meshes, frames (MuJoCo's
/// sites), and the deployment's robots with their axes, limits and postures and its sensors with their channels.
/// Lengths in m, angles in rad, quaternions x y z w. Geometry of the groups 3 to 5, which MuJoCo's own viewer hides, is
/// left out. `model` null: the robots and sensors alone. `cameras` are listed as they are. Throws
/// config::ConfigurationError for a parameter file with a mistake. Any thread.
std::string scene_json(const mjModel* model, const config::Deployment& deployment,
                       std::span<const ShownCamera> cameras = {});

}  // namespace mrroc::cli
