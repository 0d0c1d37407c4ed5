#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "sensors/camera/detection/detection.hpp"

namespace mrroc::vsp {

/// A closed outline of pixels, projected onto a plane and measured there, without perspective.
struct FlatShape {
  Eigen::Vector3d centroid;    ///< in the camera frame, m
  Eigen::Matrix3d axes;        ///< columns: greatest extent, across, the plane's normal towards the camera
  Eigen::Matrix3d covariance;  ///< of the centroid, m^2
  double rotation_deviation;   ///< of the axes about the normal, rad; at most pi/2
  double area;                 ///< m^2
};

/// Centroid, principal axes and area of the polygon `outline` (the middles of a spot's border pixels, in order, without
/// distortion) on `plane`. With the corners p_i on the plane, A and mu the polygon's area and second central moments,
/// and a_i the footprint of one pixel there, whose inside share is unknown by a uniform 1 px (variance 1/12):
///
///     covariance = sum_i (a_i / A)^2 (p_i - c)(p_i - c)^T / 12
///     sigma_rotation^2 = sum_i (a_i x_i y_i / (mu_xx - mu_yy))^2 / 12          in the principal axes
///
/// The area is scaled to that of the pixels themselves, whose borders are half a pixel further out (Pick's theorem).
/// Empty when a pixel does not see the plane or the polygon has no area.
std::optional<FlatShape> shape_on_plane(const std::vector<Eigen::Vector2d>& outline, const Intrinsics& intrinsics,
                                        const Plane& plane);

}  // namespace mrroc::vsp
