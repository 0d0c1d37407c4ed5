#pragma once

#include <array>

#include "mrroc/types.hpp"

namespace mrroc::kinematics {

/// The solutions of a canonical subproblem of inverse kinematics: one or two angles, rad in (-pi, pi]. Without an exact
/// solution the one of least squares, and `exact` is false.
struct Angles {
  std::array<double, 2> value{};
  int count = 0;
  bool exact = false;
  bool free = false;  ///< every angle is a solution
};

/// Pairs of angles: value[i] belongs to other[i].
struct AnglePairs {
  std::array<double, 2> value{}, other{};
  int count = 0;
  bool exact = false;
  bool free = false;  ///< one of the vectors is on its axis
};

/// The subproblems of Paden (1985) and Kahan (1983) in the form without special cases of Elias and Wen, "IK-Geo:
/// Unified Robot Inverse Kinematics Using Subproblem Decomposition" (2022). k, k1, k2 are unit vectors, R(k, a) is the
/// rotation about k by a. Any thread; no allocation.

/// R(k, a) p = q.
Angles rotate_onto(const Eigen::Vector3d& k, const Eigen::Vector3d& p, const Eigen::Vector3d& q) noexcept;
/// R(k1, a) p = R(k2, b) q: a in `value`, b in `other`. k1 and k2 are not parallel.
AnglePairs rotate_both(const Eigen::Vector3d& k1, const Eigen::Vector3d& p, const Eigen::Vector3d& k2,
                       const Eigen::Vector3d& q) noexcept;
/// |R(k, a) p - q| = d.
Angles rotate_to_distance(const Eigen::Vector3d& k, const Eigen::Vector3d& p, const Eigen::Vector3d& q,
                          double d) noexcept;
/// h . R(k, a) p = d.
Angles rotate_to_plane(const Eigen::Vector3d& h, const Eigen::Vector3d& k, const Eigen::Vector3d& p, double d) noexcept;

}  // namespace mrroc::kinematics
