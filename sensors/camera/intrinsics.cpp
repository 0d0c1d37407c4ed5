#include "sensors/camera/intrinsics.hpp"

#include <algorithm>
#include <opencv2/calib3d.hpp>

namespace mrroc::vsp {

bool Intrinsics::distorted() const noexcept {
  return std::any_of(distortion.begin(), distortion.end(), [](double k) { return k != 0; });
}

std::vector<Eigen::Vector2d> Intrinsics::ideal(std::vector<Eigen::Vector2d> pixels) const {
  if (!distorted() || pixels.empty()) return pixels;
  const cv::Matx33d matrix(fx, 0, cx, 0, fy, cy, 0, 0, 1);
  std::vector<cv::Point2d> points;
  points.reserve(pixels.size());
  for (const Eigen::Vector2d& pixel : pixels) points.emplace_back(pixel.x(), pixel.y());
  cv::undistortPoints(points, points, matrix, distortion, cv::noArray(), matrix);
  for (std::size_t i = 0; i < points.size(); ++i) pixels[i] = {points[i].x, points[i].y};
  return pixels;
}

}  // namespace mrroc::vsp
