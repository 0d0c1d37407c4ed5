#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <vector>

namespace mrroc::vsp {

/// A pinhole camera with OpenCV's lens distortion (Brown-Conrady; calib3d's documentation). A point (x, y, z) of the
/// camera frame is seen at
///
///     u = fx x/z + cx        v = fy y/z + cy                 (px, the middle of the upper left pixel is (0, 0))
///
/// after the lens has moved (x/z, y/z) by `distortion` = k1, k2, p1, p2, k3.
struct Intrinsics {
  int width = 0;
  int height = 0;
  double fx = 0;
  double fy = 0;
  double cx = 0;
  double cy = 0;
  std::array<double, 5> distortion{};

  /// Of a picture without distortion: f = height / (2 tan(field_of_view / 2)), its middle at ((w - 1) / 2, (h - 1) /
  /// 2). `field_of_view`: of the picture's height, rad.
  static Intrinsics pinhole(int width, int height, double field_of_view) noexcept {
    const double focal = height / (2 * std::tan(field_of_view / 2));
    return {width, height, focal, focal, (width - 1) / 2.0, (height - 1) / 2.0, {}};
  }

  /// Direction with z = 1 in which the ideal pixel is seen.
  Eigen::Vector3d ray(const Eigen::Vector2d& pixel) const noexcept {
    return {(pixel.x() - cx) / fx, (pixel.y() - cy) / fy, 1};
  }
  /// Pixel of a point in front of the camera, without distortion.
  Eigen::Vector2d project(const Eigen::Vector3d& point) const noexcept {
    return {fx * point.x() / point.z() + cx, fy * point.y() / point.z() + cy};
  }
  bool distorted() const noexcept;
  /// Where the pixels of the picture would be without distortion.
  std::vector<Eigen::Vector2d> ideal(std::vector<Eigen::Vector2d> pixels) const;
};

}  // namespace mrroc::vsp
