#pragma once

#include <filesystem>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "cli/robot/import/axis_limits.hpp"
#include "mrroc/types.hpp"
#include "sim/scene/model.hpp"

namespace mrroc::cli {

/// Names in the arm's MJCF, sorted; empty: a body of the scene.
using BodyPair = std::pair<std::string, std::string>;

/// An arm's MJCF as MuJoCo sees it: poses, contacts, inertia. One thread.
class ArmWorld {
 public:
  /// Composes `scene` with the arm at `height` (m), as a run does. Throws config::ConfigurationError with file and
  /// line: what compose and load_model refuse, warnings of MuJoCo included; a joint or site that is missing.
  ArmWorld(const std::filesystem::path& scene, double height, const std::filesystem::path& mjcf,
           const std::vector<std::string>& axes);

  /// The site `tool` in the frame of the arm's base, from MuJoCo's kinematics.
  Pose tool(const JointVector& joints);
  /// Pairs of bodies that touch, at least one of the arm; other joints are where the file has them.
  std::set<BodyPair> contacts(const JointVector& joints);
  /// Diagonal of the axes' mass matrix, kg m2 or kg.
  JointVector inertia(const JointVector& joints);
  const mjModel& model() const noexcept { return *model_; }

 private:
  void place(const JointVector& joints);
  std::string body_name(int geom) const;

  sim::Model model_;
  sim::Data data_;
  std::vector<int> positions_, velocities_;  // addresses in qpos and qvel
  int tool_ = 0, base_ = 0;                  // site, body
};

/// A random posture within the limits, in +-pi (1 m) where an axis has none.
JointVector random_posture(const std::vector<AxisLimits>& axes, std::mt19937_64& random);

}  // namespace mrroc::cli
