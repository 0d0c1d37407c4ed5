#pragma once

#include <Eigen/Geometry>
#include <string>

#include "cli/robot/import/urdf_bodies.hpp"

namespace mrroc::cli {

/// A rigid body's mass in its principal axes, as MuJoCo accepts it: positive, with the triangle inequality.
struct BodyInertia {
  Pose axes = Pose::Identity();                       ///< centre of mass and principal axes, in the link's frame
  double mass = 0;                                    ///< kg
  Eigen::Vector3d moments = Eigen::Vector3d::Zero();  ///< kg m2
};

/// Why the numbers of a URDF cannot be used: a mass or a moment that is not positive, moments that no body has
/// (A + B < C by more than one per cent), moments or a density that do not fit the link's size (`box`, empty:
/// unknown). Empty if they can.
std::string inertia_problem(const UrdfInertial& inertial, const Eigen::AlignedBox3d& box);

/// The principal axes of numbers without a problem; moments that break the triangle inequality by rounding are raised.
BodyInertia principal_inertia(const UrdfInertial& inertial);

/// A full box of 500 kg/m3; for an empty one a ball of 0.1 kg with a radius of 2 cm.
BodyInertia guessed_inertia(const Eigen::AlignedBox3d& box);

}  // namespace mrroc::cli
