#pragma once

#include <kdl/frames.hpp>

#include "mrroc/types.hpp"

namespace mrroc::fakes {

inline KDL::Vector to_kdl(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
inline KDL::Rotation to_kdl(const Eigen::Matrix3d& r) {
  return {r(0, 0), r(0, 1), r(0, 2), r(1, 0), r(1, 1), r(1, 2), r(2, 0), r(2, 1), r(2, 2)};
}
inline KDL::Frame to_kdl(const Pose& pose) {
  return {to_kdl(Eigen::Matrix3d(pose.linear())), to_kdl(Eigen::Vector3d(pose.translation()))};
}
inline Pose from_kdl(const KDL::Frame& frame) {
  Pose pose = Pose::Identity();
  for (int i = 0; i < 3; ++i) {
    pose.translation()[i] = frame.p[i];
    for (int k = 0; k < 3; ++k) pose.linear()(i, k) = frame.M(i, k);
  }
  return pose;
}

}  // namespace mrroc::fakes
