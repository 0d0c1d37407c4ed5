#pragma once

#include <rapidcheck.h>

#include <Eigen/SVD>
#include <limits>

#include "robots_polycrank/polycrank_fixture.hpp"

namespace mrroc {

/// 0..2^30 - 1, evenly distributed in small cases too; part of the rapidcheck case, so that a failure shrinks and
/// replays.
inline constexpr int kSteps = 1 << 30;
inline int any_step() { return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, kSteps)); }

inline double any_between(double low, double high) { return low + (high - low) * any_step() / (kSteps - 1); }

/// Up to three turns from zero.
inline JointVector any_joints() {
  std::mt19937_64 random(static_cast<std::uint64_t>(any_step()));
  return random_joints(random);
}

/// Every joint at most `distance` (rad) away from `joints`.
inline JointVector any_near(const JointVector& joints, double distance) {
  JointVector near = joints;
  for (int i = 0; i < 7; ++i) near[i] += any_between(-distance, distance);
  return near;
}

/// The least of the Jacobian's six singular values: how far the arm is from losing a direction.
inline double dexterity(const JointVector& joints) {
  return Eigen::JacobiSVD<Eigen::MatrixXd>(flange_jacobian(joints)).singularValues()[5];
}

/// Numbers of every size, infinities and NaN among them.
inline double any_garbage() {
  const double mantissa = any_between(-10, 10);
  switch (*rc::gen::inRange(0, 12)) {
    case 0:
      return std::numeric_limits<double>::quiet_NaN();
    case 1:
      return std::numeric_limits<double>::infinity();
    case 2:
      return -std::numeric_limits<double>::infinity();
    case 3:
      return 0;
    case 4:
    case 5:
      return std::ldexp(mantissa, *rc::gen::inRange(-1060, 1020));
    default:
      return mantissa;
  }
}

inline JointVector any_garbage_joints() {
  JointVector joints(7);
  for (int i = 0; i < 7; ++i) joints[i] = any_garbage();
  return joints;
}

}  // namespace mrroc
