#pragma once

#include "mrroc/types.hpp"

namespace mrroc {

/// A load on the tool: its mass (kg) and its centre of gravity (m) in a frame that is fixed to it, usually the tool
/// frame.
struct Load {
  double mass = 0;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
};

/// Standard gravity in an upright base frame, m/s^2.
inline Eigen::Vector3d standard_gravity() noexcept { return {0, 0, -9.81}; }

/// The wrench that the load's weight exerts at rest, in the axes of its frame and about its origin, where the frame is
/// rotated by `rotation` in the base frame:  f = R^T m g,  t = c x f.  `gravity` in the base frame. Any thread; never
/// throws.
inline Wrench weight_of(const Load& load, const Eigen::Matrix3d& rotation,
                        const Eigen::Vector3d& gravity = standard_gravity()) {
  const Eigen::Vector3d force = load.mass * (rotation.transpose() * gravity);
  Wrench wrench;
  wrench << force, load.centre.cross(force);
  return wrench;
}

}  // namespace mrroc
