#pragma once

#include <Eigen/SVD>
#include <random>

#include "robots/common/any_number.hpp"
#include "robots/polycrank/polycrank_fixture.hpp"

namespace mrroc {

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

/// The smallest of the Jacobian's six singular values: the distance of the arm from a singularity.
inline double dexterity(const JointVector& joints) {
  return Eigen::JacobiSVD<Eigen::MatrixXd>(flange_jacobian(joints)).singularValues()[5];
}

}  // namespace mrroc
