#include "kinematics/newton.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace mrroc::kinematics {

namespace {

constexpr double kLeastDamping = 1e-12, kMostDamping = 1e6;
constexpr double kLongestStep = 0.6;  // rad or m of one joint: beyond it the linearisation says nothing

}  // namespace

Twist displacement(const Pose& from, const Pose& to) noexcept {
  Twist difference;
  difference.head<3>() = to.translation() - from.translation();
  Eigen::Quaterniond turn(to.linear() * from.linear().transpose());
  turn.normalize();
  if (turn.w() < 0) turn.coeffs() = -turn.coeffs();
  const double sine = turn.vec().norm();
  const double factor = sine < 1e-12 ? 2.0 : 2 * std::atan2(sine, turn.w()) / sine;
  difference.tail<3>() = factor * turn.vec();
  return difference;
}

bool improve(const SerialChain& chain, const Pose& target, double tolerance, int iterations, JointVector& joints,
             const JointRange* range) noexcept {
  SerialChain::Axes axes;
  chain.compute(joints, axes);
  Twist error = displacement(axes.flange, target);
  double damping = 1e-6;
  for (int i = 0; i < iterations; ++i) {
    if (error.head<3>().norm() < tolerance && error.tail<3>().norm() < tolerance) return true;
    const Jacobian jacobian = chain.jacobian(axes, Eigen::Vector3d::Zero());
    JointMatrix normal = jacobian.transpose() * jacobian;
    normal.diagonal().array() += damping;
    JointVector step = normal.ldlt().solve(jacobian.transpose() * error);
    const double longest = step.cwiseAbs().maxCoeff();
    if (!std::isfinite(longest)) return false;
    if (longest > kLongestStep) step *= kLongestStep / longest;
    JointVector next = joints + step;
    if (range != nullptr) next = next.cwiseMax(range->min).cwiseMin(range->max);
    SerialChain::Axes there;
    chain.compute(next, there);
    const Twist rest = displacement(there.flange, target);
    if (rest.squaredNorm() < error.squaredNorm()) {
      joints = next;
      axes = there;
      error = rest;
      damping = std::max(damping / 10, kLeastDamping);
    } else {
      damping *= 10;
      if (damping > kMostDamping) return false;
    }
  }
  return error.head<3>().norm() < tolerance && error.tail<3>().norm() < tolerance;
}

}  // namespace mrroc::kinematics
