#pragma once

#include <mujoco/mujoco.h>

#include <array>
#include <memory>

#include "mrroc/types.hpp"

namespace mrroc {

/// serial_parallel.xml with its loops closed by MuJoCo's own constraints: Newton's method on the residuals of the
/// connects finds the joints without a motor. The kinematic model is not used.
class ClosedMjcf {
 public:
  /// Throws std::runtime_error with MuJoCo's message when the file does not load.
  ClosedMjcf();

  std::unique_ptr<mjModel, decltype(&mj_deleteModel)> model;
  std::unique_ptr<mjData, decltype(&mj_deleteData)> data;

  /// Sets the six driven joints to `joints` and closes the loops, from the previous state. False: they do not close.
  bool close(const JointVector& joints);
  /// Restores the file's own state.
  void reset();
  /// Largest residual of the loops, m, after `close`, mj_forward or mj_step.
  double residual() const;
  /// Pose of a site, after `close`, mj_kinematics or mj_forward.
  Pose site(const char* name) const;
  /// d twist of the site "tool" / d driven joints, with closed loops; after `close`.
  Jacobian tool_jacobian() const;
  /// Forces (N) and torques (N m) of the driven joints that carry the weight of all parts; after `close`.
  JointVector holding_forces();

 private:
  int dof(const char* joint) const;
  std::array<int, 6> driven_{}, passive_{};  ///< degrees of freedom; every joint has one position
};

}  // namespace mrroc
