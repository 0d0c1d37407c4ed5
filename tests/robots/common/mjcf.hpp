#pragma once

#include <mujoco/mujoco.h>

#include <filesystem>
#include <memory>

#include "mrroc/types.hpp"

namespace mrroc {

/// A loaded MJCF and its state. Throws std::runtime_error with MuJoCo's message when the file does not load.
struct Mjcf {
  explicit Mjcf(const std::filesystem::path& file);
  std::unique_ptr<mjModel, decltype(&mj_deleteModel)> model;
  std::unique_ptr<mjData, decltype(&mj_deleteData)> data;

  void set_joints(const JointVector& joints);
  /// Pose of a site, after mj_kinematics or mj_forward.
  Pose site(const char* name) const;
  /// Joint inertia matrix, after mj_forward; armature included.
  JointMatrix mass_matrix() const;
};

}  // namespace mrroc
