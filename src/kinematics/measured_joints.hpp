#pragma once

#include <vector>

#include "mrroc/measured_arm.hpp"

namespace mrroc::kinematics {

/// The joints q of an arm as measured, and the readings e of its encoders as the type's model computes them:
///
///   q_i = e_i + d_i + r_i e_i + c_i (cos e_i - 1) + s_i sin e_i
///
/// with MeasuredArm's zeros d and gears (r, c, s). Any thread; nothing but the constructor allocates.
class MeasuredJoints {
 public:
  /// Throws SystemError(configuration): numbers of zeros or gears that are not `count`.
  MeasuredJoints(const MeasuredArm& measured, int count);

  JointVector joints(const JointVector& encoders) const noexcept;
  /// The inverse of `joints`, by Newton's iteration.
  JointVector encoders(const JointVector& joints) const noexcept;
  /// dq_i / de_i.
  JointVector slopes(const JointVector& encoders) const noexcept;

 private:
  JointVector zeros_;
  std::vector<Eigen::Vector3d> gears_;
};

}  // namespace mrroc::kinematics
