#pragma once

#include <rapidcheck.h>

#include "language/rigid_motion.hpp"

namespace mrroc::fakes {

/// Within a property: a number from `from` to `to`.
inline int pick(int from, int to) { return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(from, to + 1)); }

/// Each coordinate of at most `largest`.
inline Eigen::Vector3d random_vector(double largest) {
  return Eigen::Vector3d(pick(-100, 100), pick(-100, 100), pick(-100, 100)) * (0.01 * largest);
}

inline Pose random_pose(double largest, double turn) {
  Pose pose = Pose::Identity();
  pose.translation() = random_vector(largest);
  pose.linear() = rotation_of(random_vector(turn));
  return pose;
}

}  // namespace mrroc::fakes
