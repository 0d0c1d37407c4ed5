#pragma once

#include <string>

namespace mrroc::cli {

/// The height of the pedestal on which demo_scene() has an arm, m.
double demo_height(double reach);

/// A deployment that runs the stock demo with an arm of `type` in demo_scene(). Any thread.
std::string demo_deployment(const std::string& type, double reach);

/// A deployment in which the arm follows trajectories of other programs, in the same scene. Any thread.
std::string external_deployment(const std::string& type, double reach);

/// MJCF of a floor and a pedestal on which the arm is; `reach`: of the arm, m, for the pedestal and the camera.
std::string demo_scene(const std::string& type, double reach);

}  // namespace mrroc::cli
