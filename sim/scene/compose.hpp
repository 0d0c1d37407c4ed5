#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "config/entries/errors_entry.hpp"
#include "mrroc/types.hpp"
#include "sim/scene/xml.hpp"

namespace mrroc::sim {

/// One robot to be put into the world.
struct RobotPart {
  std::string name;              ///< of the deployment's robot: the prefix of all its names
  std::filesystem::path mjcf;    ///< robots/<type>/<type>.xml, a complete MJCF
  Pose base = Pose::Identity();  ///< in the world, or in the frame of the carrier's site "tool"
  /// The robot carries a force/torque sensor: `<robot>/force_torque/force` and `.../torque` on site `<robot>/wrist`
  /// are added unless its MJCF declares them.
  bool force_torque = false;
  std::string mount = {};                          ///< robot that carries it; empty: it is fixed in the world
  std::optional<config::ErrorsEntry> errors = {};  ///< of its links
};

/// A world's MJCF before MuJoCo compiles it.
struct Composition {
  std::filesystem::path scene;
  Element root;
  Text text;  ///< `root`, written
};

/// Composes one MJCF from a scene and robots, as text, because MuJoCo 2.2 cannot attach models.
///
/// - The scene keeps its names. Every name of a robot, and every reference to one, gets the prefix "<robot>/".
/// - A robot's worldbody becomes a new body "<robot>" at its base pose, in the world or on the robot that carries it
///   (`place_robots`).
/// - Defaults stay with their file: each file's main class becomes "<robot>/main" ("/main" for the scene).
/// - `option`, `size`, `visual`, `statistic` are the scene's, the robots' are omitted; so are all keyframes.
/// - `compiler` settings that change the meaning of numbers (angle, eulerseq, ...) must agree in all files; folders of
///   meshes and textures are each file's own.
/// - A scene without light, sky or `visual` gets plain ones (they change pictures only).
///
/// Throws config::ConfigurationError with file and line: unreadable or malformed file, `compiler` settings that differ,
/// a number that is not finite or beyond 1e10 (MuJoCo loads both and diverges), a carrier without a site "tool",
/// a name twice (`check_names`).
Composition compose(const std::filesystem::path& scene, const std::vector<RobotPart>& robots);

}  // namespace mrroc::sim
