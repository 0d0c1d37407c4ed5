#pragma once

#include "mrroc/robot_model.hpp"
#include "robots/serial_parallel/geometry.hpp"
#include "robots/serial_parallel/tripod.hpp"

namespace mrroc::serial_parallel {

/// Joints <-> flange pose in the base frame. Joints: lengths of legs A, B, C (m), then turn, bend and roll of the wrist
/// (rad; wrist.hpp). The tripod hangs: the base frame is its frame turned by half a turn about x, z up, x towards leg
/// B.
///
/// Direct: the legs give the platform's placement (Newton's method, Tripod::assemble), all else is closed form.
/// Inverse: closed form. Joints whose legs do not close get the pose with the platform level, so that every result is
/// finite. Any thread; never allocates or throws.
class Kinematics {
 public:
  explicit Kinematics(const Geometry& geometry) noexcept;

  /// Whether the legs close with every passive joint within its limit, `allowance` rad granted.
  bool reaches(const JointVector& joints, double allowance) const noexcept;

  Pose flange(const JointVector& joints) const noexcept;

  /// The platform's placement by the legs; level when they do not close.
  Placement placement(const JointVector& joints) const noexcept;
  PassiveAngles passive_angles(const Placement& placement) const noexcept { return tripod_.passive_angles(placement); }

  /// `none`; `singular` as for the wrist; `out_of_workspace` when a passive joint would pass its limit, the pose is
  /// not a rigid motion within 1e-6 or a value is not finite (then `joints` is unchanged).
  ErrorCode inverse(const Pose& flange, const JointVector& near, JointVector& joints) const noexcept;

  /// As `RobotModel::branches`: both branches of the wrist, `allowance` (rad) granted to the passive joints. With the
  /// wrist straight its turn covers a revolution in `kFreeSteps` steps.
  void branches(const Pose& flange, const JointVector& near, double allowance, BranchReceiver& receiver) const noexcept;
  static constexpr int kFreeSteps = 720;

  /// Geometric Jacobian of a point fixed to the flange, `offset` in flange axes, in base axes. The legs' part is
  /// d placement / d legs, the inverse of Tripod::leg_rates, carried on to the wrist's centre.
  Jacobian jacobian(const JointVector& joints, const Eigen::Vector3d& offset) const noexcept;

 private:
  Pose flange(const Placement& placement, const JointVector& joints) const noexcept;

  Tripod tripod_;
  double base_b_;
  double platform_to_wrist_;
  double wrist_to_flange_;
};

}  // namespace mrroc::serial_parallel
