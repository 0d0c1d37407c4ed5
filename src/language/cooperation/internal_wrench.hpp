#pragma once

#include <vector>

#include "mrroc/types.hpp"

namespace mrroc {

/// Splits the wrenches between n arms and the object that they hold into those that move it and the internal ones,
/// which do not. All in one set of axes. Stacks of 6 n: per arm force (N) and torque about its grasp divided by
/// `length` (N), or translation (m) and rotation times `length` (m). With
///
///   W = [ I  0 ; [r_1] / l  I  ...  I  0 ; [r_n] / l  I ]      [r]: the matrix of r x
///
/// r_i from the middle of the grasps to grasp i, W h is the total wrench about the middle, and
///
///   P = I - W^T (W W^T)^-1 W
///
/// the orthogonal projection onto wrenches with zero total, and onto displacements of the grasps that do not move a
/// rigid object. Allocates in the constructor only; never throws.
class InternalWrench {
 public:
  InternalWrench() = default;
  InternalWrench(const std::vector<Eigen::Vector3d>& grasps, double length);

  /// internal = P stack. The two must not be the same.
  void of(const Eigen::VectorXd& stack, Eigen::VectorXd& internal) const noexcept {
    internal.noalias() = matrix_ * stack;
  }
  const Eigen::MatrixXd& matrix() const noexcept { return matrix_; }

  /// Every arm presses with `force` N towards the middle of the grasps: the internal part of the wrenches of the object
  /// on the arms. Exact for two arms, and for grasps spaced evenly around the middle.
  Eigen::VectorXd squeeze(double force) const;

 private:
  std::vector<Eigen::Vector3d> arms_;  // r_i
  Eigen::MatrixXd matrix_;
};

}  // namespace mrroc
