#pragma once

#include "mrroc/errors.hpp"
#include "mrroc/types.hpp"
#include "robots/irb6/geometry.hpp"

namespace mrroc::irb6 {

/// Joints (rad) <-> flange pose in the base frame, in closed form. The base frame is at the shoulder, z up, x forward
/// at q1 = 0. With the absolute arm angles t2 = q2, t3 = q2 + q3 + pi/2, t4 = t3 + q4 (0 forward, +pi/2 down) and r =
/// lower_arm cos t2 + upper_arm cos t3 + wrist cos t4, the flange is at (r cos q1, r sin q1, -lower_arm sin t2 -
/// upper_arm sin t3 - wrist sin t4). Wrist roll q5 turns about the wrist's own direction, tool roll q6 about the
/// flange's z axis, which is at right angles to it. At t4 = q5 = q6 = 0 the flange's x axis is up, y forward, z to the
/// left. Any thread; never allocates or throws.
class Kinematics {
 public:
  explicit Kinematics(const Geometry& geometry) noexcept;

  /// Flange pose; finite for finite joints.
  Pose flange(const JointVector& joints) const noexcept;

  /// Joints of a flange pose. The arm reaches forward (q1 = atan2(y, x)) and its elbow points up (t3 > t2): the other
  /// branches are beyond the screws. Of the two wrist branches (q5, t4, q6) and (-q5, t4 + pi, q6 + pi) the one with
  /// the smaller sum of changes of q4, q5, q6 from `near`. q5 is the turn nearest to `near`, q1, t4 and q6 are within
  /// (-pi, pi]. `none`; `singular` when q5 is a multiple of pi (t4 is kept from `near`) or the flange is above the
  /// shoulder (q1 is kept); `out_of_workspace` when no joints belong to the pose, it is not a rigid motion within 1e-6
  /// or a value is not finite (then `joints` is left as it was).
  ErrorCode inverse(const Pose& flange, const JointVector& near, JointVector& joints) const noexcept;

  /// Geometric Jacobian of a point fixed to the flange, `offset` in flange axes, in base axes.
  Jacobian jacobian(const JointVector& joints, const Eigen::Vector3d& offset) const noexcept;

 private:
  double lower_arm_;
  double upper_arm_;
  double wrist_;
};

}  // namespace mrroc::irb6
