#pragma once

#include "mrroc/robot_model.hpp"
#include "robots/irb6/arm_plane.hpp"

namespace mrroc::irb6 {

/// Joints (rad) <-> flange pose in the base frame of the arm with five axes, in closed form. The flange is at the
/// wrist's end (`ArmPlane::end`), its z axis along the wrist; roll q5 turns about it. At t4 = q5 = 0 the flange's x
/// axis is up, y to the right, z forward. Any thread; never allocates or throws.
class FiveAxisKinematics {
 public:
  /// Tolerance (sine of the angle) of a pose's z axis to the arm's vertical plane: it is turned into the plane,
  /// as measured poses require.
  static constexpr double kPlaneTolerance = 5e-3;

  explicit FiveAxisKinematics(const Geometry& geometry) noexcept : plane_(geometry) {}

  /// Flange pose; finite for finite joints.
  Pose flange(const JointVector& joints) const noexcept;

  /// Joints of a flange pose: the arm reaches forward (q1 = atan2(y, x)) with its elbow up, so there is one solution at
  /// most. q5 is the revolution nearest to `near`, q1 and t4 are within (-pi, pi]. Solutions follow from the geometry,
  /// within the limits or not: nothing is clamped. `none`; `singular` when the flange is above the shoulder (then q1
  /// follows from the z axis, or from `near` when that is vertical); `out_of_workspace` when the z axis is out of the
  /// arm's vertical plane by more than kPlaneTolerance, when it is out of reach, the pose is not a rigid motion within
  /// 1e-6 or a value is not finite (then `joints` is unchanged).
  ErrorCode inverse(const Pose& flange, const JointVector& near, JointVector& joints) const noexcept;

  /// As `RobotModel::branches`: forward and backward reach, the z axis turned into the arm's plane. Near the column's
  /// axis also the column angle that the z axis requires. Above the shoulder with a vertical z axis the column
  /// covers a revolution in `kFreeSteps` steps.
  /// Behind the column the search reaches up to `behind` m (`ArmPlane::behind`).
  void branches(const Pose& flange, const JointVector& near, double behind, BranchReceiver& receiver) const noexcept;
  static constexpr int kFreeSteps = 720;
  static std::string_view branch_name(const JointVector&) noexcept { return "elbow up"; }

  /// Geometric Jacobian (6 x 5) of a point fixed to the flange, `offset` in flange axes, in base axes.
  Jacobian jacobian(const JointVector& joints, const Eigen::Vector3d& offset) const noexcept;

  const ArmPlane& plane() const noexcept { return plane_; }

 private:
  void reach(const Pose& flange, const JointVector& near, double column, double forward_reach,
             BranchReceiver& receiver) const noexcept;

  ArmPlane plane_;
};

}  // namespace mrroc::irb6
