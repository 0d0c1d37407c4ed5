#pragma once

#include <rapidcheck.h>

#include "geometry/rigid_motion.hpp"

namespace mrroc::fakes {

/// Within a property: uniform in from..to, at any size; shrinks to `from`.
inline int pick(int from, int to) { return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(from, to + 1)); }

/// From `from` to `to`, to 1e-5 of the range.
inline double number(double from, double to) { return from + (to - from) * pick(0, 100'000) / 100'000.0; }

/// Each coordinate of at most `largest`.
inline Eigen::Vector3d random_vector(double largest) {
  return Eigen::Vector3d(pick(-100, 100), pick(-100, 100), pick(-100, 100)) * (0.01 * largest);
}

/// At most `largest` m along each axis, turned by a rotation vector of at most `turn` rad about each.
inline Pose random_pose(double largest, double turn) {
  Pose pose = Pose::Identity();
  pose.translation() = random_vector(largest);
  pose.linear() = exp_rotation(random_vector(turn));
  return pose;
}

}  // namespace mrroc::fakes
