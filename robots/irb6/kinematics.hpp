#pragma once

#include <cmath>

#include "mrroc/robot_model.hpp"
#include "robots/irb6/arm_plane.hpp"

namespace mrroc::irb6 {

/// Joints (rad) <-> flange pose in the base frame of the arm with six axes, in closed form. The flange is at the
/// wrist's end (`ArmPlane::end`), where the two roll axes cross. Wrist roll q5 turns about the wrist's own direction,
/// tool roll q6 about the flange's z axis, which is at right angles to it. At t4 = q5 = q6 = 0 the flange's x axis is
/// up, y forward, z to the left. Any thread; never allocates or throws.
class Kinematics {
 public:
  explicit Kinematics(const Geometry& geometry) noexcept : plane_(geometry) {}

  /// Flange pose; finite for finite joints.
  Pose flange(const JointVector& joints) const noexcept;

  /// Joints of a flange pose. The arm reaches forward (q1 = atan2(y, x)) and its elbow points up: the other branches
  /// are beyond the screws. Of the two wrist branches (q5, t4, q6) and (-q5, t4 + pi, q6 + pi) the one with the smaller
  /// sum of changes of q4, q5, q6 from `near`. q5 is the revolution nearest to `near`, q1, t4 and q6 are within (-pi,
  /// pi]. `none`; `singular` when q5 is a multiple of pi (t4 is kept from `near`) or the flange is above the shoulder
  /// (q1 is kept); `out_of_workspace` when no joints belong to the pose, it is not a rigid motion within 1e-6 or a
  /// value is not finite (then `joints` is unchanged).
  ErrorCode inverse(const Pose& flange, const JointVector& near, JointVector& joints) const noexcept;

  /// As `RobotModel::branches`: forward and backward reach, both wrist branches. With the roll axes aligned or the
  /// flange above the shoulder the free angle covers a revolution in `kFreeSteps` steps.
  /// Behind the column the search reaches up to `behind` m (`ArmPlane::behind`).
  void branches(const Pose& flange, const JointVector& near, double behind, BranchReceiver& receiver) const noexcept;
  static constexpr int kFreeSteps = 720;
  static std::string_view branch_name(const JointVector& joints) noexcept {
    return std::sin(joints[4]) < 0 ? "elbow up, sin q5 < 0" : "elbow up, sin q5 >= 0";
  }

  /// Geometric Jacobian of a point fixed to the flange, `offset` in flange axes, in base axes.
  Jacobian jacobian(const JointVector& joints, const Eigen::Vector3d& offset) const noexcept;

  const ArmPlane& plane() const noexcept { return plane_; }

 private:
  /// An angle of the column and the axes of a level wrist there.
  struct Column {
    explicit Column(double its_angle) noexcept : angle(its_angle), level(its_angle, 0) {}
    double angle;
    ArmAxes level;
  };
  void reach(const Pose& flange, const JointVector& near, const Column& at, double forward_reach, bool aligned,
             BranchReceiver& receiver) const noexcept;

  ArmPlane plane_;
};

}  // namespace mrroc::irb6
