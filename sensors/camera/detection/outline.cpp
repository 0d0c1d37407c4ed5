#include "sensors/camera/detection/outline.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mrroc::vsp {

namespace {

constexpr double kVarianceOfAPixel = 1.0 / 12;
/// Below this cosine the plane is seen edge on: a pixel covers most of it.
constexpr double kEdgeOn = 1e-3;

/// Area and first and second moments of a polygon about the origin (Green's theorem).
struct Moments {
  double area = 0;
  Eigen::Vector2d first = Eigen::Vector2d::Zero();
  Eigen::Matrix2d second = Eigen::Matrix2d::Zero();
};

Moments moments_of(const std::vector<Eigen::Vector2d>& polygon) {
  Moments moments;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& a = polygon[i];
    const Eigen::Vector2d& b = polygon[(i + 1) % polygon.size()];
    const double cross = a.x() * b.y() - b.x() * a.y();
    moments.area += cross / 2;
    moments.first += cross / 6 * (a + b);
    moments.second +=
        cross / 24 * (2 * a * a.transpose() + 2 * b * b.transpose() + a * b.transpose() + b * a.transpose());
  }
  if (moments.area < 0) return {-moments.area, -moments.first, -moments.second};
  return moments;
}

/// Share by which the pixels of a spot exceed the polygon through the middles of its border.
double border_share(const std::vector<Eigen::Vector2d>& outline) {
  const double area = moments_of(outline).area;
  return (area + static_cast<double>(outline.size()) / 2 + 1) / area;
}

struct FlatPoint {
  Eigen::Vector3d point;
  double footprint;  ///< of its pixel, m^2
};

/// Every pixel on the plane; empty when one of them does not see it.
std::vector<FlatPoint> on_plane(const std::vector<Eigen::Vector2d>& outline, const Intrinsics& intrinsics,
                                const Plane& plane) {
  std::vector<FlatPoint> points;
  points.reserve(outline.size());
  for (const Eigen::Vector2d& pixel : outline) {
    const Eigen::Vector3d ray = intrinsics.ray(pixel);
    const double facing = plane.normal.dot(ray);
    const double depth = plane.distance / facing;
    if (!(std::abs(facing) > kEdgeOn * ray.norm()) || !(depth > 0)) return {};
    points.push_back({depth * ray, depth * depth / (intrinsics.fx * intrinsics.fy * std::abs(facing))});
  }
  return points;
}

/// Axes of the plane: the normal towards the camera, whose own z axis points away from it.
Eigen::Matrix3d axes_of(const Plane& plane) {
  const Eigen::Vector3d z = plane.distance > 0 ? Eigen::Vector3d(-plane.normal) : plane.normal;
  const Eigen::Vector3d along = std::abs(z.x()) < 0.9 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY();
  Eigen::Matrix3d axes;
  axes.col(0) = (along - along.dot(z) * z).normalized();
  axes.col(1) = z.cross(axes.col(0));
  axes.col(2) = z;
  return axes;
}

}  // namespace

std::optional<FlatShape> shape_on_plane(const std::vector<Eigen::Vector2d>& outline, const Intrinsics& intrinsics,
                                        const Plane& plane) {
  const std::vector<FlatPoint> points = on_plane(outline, intrinsics, plane);
  if (points.size() < 3) return std::nullopt;
  const Eigen::Matrix3d axes = axes_of(plane);
  const Eigen::Vector3d origin = points.front().point;
  std::vector<Eigen::Vector2d> flat;
  flat.reserve(points.size());
  for (const FlatPoint& each : points) flat.emplace_back((axes.transpose() * (each.point - origin)).head<2>());

  const Moments moments = moments_of(flat);
  if (!(moments.area > 0)) return std::nullopt;
  const Eigen::Vector2d centroid = moments.first / moments.area;
  const Eigen::Matrix2d mu = moments.second - moments.area * centroid * centroid.transpose();
  const double angle = std::atan2(2 * mu(0, 1), mu(0, 0) - mu(1, 1)) / 2;
  const Eigen::Rotation2Dd principal(angle);
  const double elongation = std::hypot(mu(0, 0) - mu(1, 1), 2 * mu(0, 1));

  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  double rotation_variance = 0;
  for (std::size_t i = 0; i < flat.size(); ++i) {
    const Eigen::Vector2d arm = principal.inverse() * (flat[i] - centroid) * points[i].footprint;
    covariance += kVarianceOfAPixel * arm * arm.transpose() / (moments.area * moments.area);
    const double turn = arm.x() * arm.y() / points[i].footprint;
    rotation_variance += kVarianceOfAPixel * turn * turn / std::max(elongation * elongation, 1e-300);
  }
  FlatShape shape;
  shape.centroid = origin + axes.leftCols<2>() * centroid;
  shape.axes = axes;
  shape.axes.leftCols<2>() = axes.leftCols<2>() * principal.toRotationMatrix();
  shape.covariance = shape.axes.leftCols<2>() * covariance * shape.axes.leftCols<2>().transpose();
  shape.rotation_deviation = std::min(std::sqrt(rotation_variance), std::numbers::pi / 2);
  shape.area = moments.area * border_share(outline);
  return shape;
}

}  // namespace mrroc::vsp
