#include "sensors/camera/detection/square_edges.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>

namespace mrroc::vsp {

namespace {

constexpr double kMargin = 0.1;   ///< of a side, at either end: rounded off
constexpr double kStep = 0.5;     ///< px, along the normal
constexpr double kMostReach = 3;  ///< px
constexpr double kLeastContrast = 8;

/// A line n . p = d, |n| = 1.
struct Line {
  Eigen::Vector2d normal;
  double distance;
};

/// Brightness between pixels, bilinear; none outside of the picture.
std::optional<double> brightness(const cv::Mat& grey, const Eigen::Vector2d& at) {
  const int x = static_cast<int>(std::floor(at.x())), y = static_cast<int>(std::floor(at.y()));
  if (x < 0 || y < 0 || x + 1 >= grey.cols || y + 1 >= grey.rows) return std::nullopt;
  const double fx = at.x() - x, fy = at.y() - y;
  const auto pixel = [&](int dx, int dy) { return static_cast<double>(grey.at<std::uint8_t>(y + dy, x + dx)); };
  return (1 - fy) * ((1 - fx) * pixel(0, 0) + fx * pixel(1, 0)) + fy * ((1 - fx) * pixel(0, 1) + fx * pixel(1, 1));
}

/// Position, from `point` along `outwards`, where black becomes white: the centre of the gradient within `reach`.
std::optional<double> edge_offset(const cv::Mat& grey, const Eigen::Vector2d& point, const Eigen::Vector2d& outwards,
                                  double reach) {
  double sum = 0, moment = 0;
  for (double s = -reach; s < reach - kStep / 2; s += kStep) {
    const auto inner = brightness(grey, point + s * outwards), outer = brightness(grey, point + (s + kStep) * outwards);
    if (!inner || !outer) return std::nullopt;
    const double rise = std::max(0.0, *outer - *inner);
    sum += rise;
    moment += rise * (s + kStep / 2);
  }
  if (sum < kLeastContrast) return std::nullopt;
  return moment / sum;
}

/// The line through the side from `a` to `b`; `outwards` is its normal.
std::optional<Line> side_line(const cv::Mat& grey, const Eigen::Vector2d& a, const Eigen::Vector2d& b, double reach) {
  const Eigen::Vector2d along = (b - a).normalized();
  const Eigen::Vector2d outwards(along.y(), -along.x());  // clockwise with y downwards: the inside is to the right
  const int count = std::clamp(static_cast<int>((b - a).norm()), 8, 60);
  std::vector<Eigen::Vector2d> points;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector2d point = a + (kMargin + (1 - 2 * kMargin) * (i + 0.5) / count) * (b - a);
    const auto offset = edge_offset(grey, point, outwards, reach);
    if (!offset) continue;
    points.push_back(point + *offset * outwards);
    mean += points.back();
  }
  if (static_cast<int>(points.size()) < count / 2) return std::nullopt;
  mean /= static_cast<double>(points.size());
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (const Eigen::Vector2d& point : points) scatter += (point - mean) * (point - mean).transpose();
  const Eigen::Vector2d normal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(scatter).eigenvectors().col(0);
  return Line{normal, normal.dot(mean)};
}

std::optional<Eigen::Vector2d> meeting(const Line& a, const Line& b) {
  Eigen::Matrix2d normals;
  normals << a.normal.transpose(), b.normal.transpose();
  if (std::abs(normals.determinant()) < 1e-3) return std::nullopt;
  return Eigen::Vector2d(normals.inverse() * Eigen::Vector2d(a.distance, b.distance));
}

}  // namespace

std::vector<Eigen::Vector2d> refine_square(const cv::Mat& grey, const std::vector<Eigen::Vector2d>& corners,
                                           double cell) {
  const double reach = std::clamp(0.4 * cell, 1.0, kMostReach);
  std::vector<Line> sides;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto side = side_line(grey, corners[i], corners[(i + 1) % 4], reach);
    if (!side) return corners;
    sides.push_back(*side);
  }
  std::vector<Eigen::Vector2d> refined;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto corner = meeting(sides[(i + 3) % 4], sides[i]);
    if (!corner || (*corner - corners[i]).norm() > 2 * reach) return corners;
    refined.push_back(*corner);
  }
  return refined;
}

}  // namespace mrroc::vsp
