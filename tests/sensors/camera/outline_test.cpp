#include "sensors/camera/detection/outline.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "geometry/rigid_motion.hpp"
#include "sensors/camera/detection/marker_detector.hpp"

namespace mrroc::vsp::outline_test {
namespace {

double between(double from, double to) { return from + (to - from) * *rc::gen::inRange(0, 10001) / 10000; }

const Intrinsics kCamera = Intrinsics::pinhole(640, 480, 0.8);

/// A frame in front of the camera whose z axis points towards it, within 60 degrees.
Pose any_pose() {
  const Pose facing = pose_from_rpy({between(-0.1, 0.1), between(-0.1, 0.1), between(0.4, 1.5)}, {M_PI, 0, 0});
  return facing * pose_from_rpy({0, 0, 0}, {between(-0.7, 0.7), between(-0.7, 0.7), 0}) *
         pose_from_rpy({0, 0, 0}, {0, 0, between(-3, 3)});
}

std::vector<Eigen::Vector2d> seen(const std::vector<Eigen::Vector3d>& points) {
  std::vector<Eigen::Vector2d> pixels;
  for (const Eigen::Vector3d& point : points) pixels.push_back(kCamera.project(point));
  return pixels;
}

TEST(Outline, PolygonOnAPlaneIsMeasuredWithoutPerspective) {
  EXPECT_TRUE(rc::check([] {
    const Pose pose = any_pose();
    const double length = between(0.05, 0.1), width = between(0.01, 0.04);
    std::vector<Eigen::Vector3d> corners;
    for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
      corners.push_back(pose * Eigen::Vector3d(x * length / 2, y * width / 2, 0));
    const Plane plane = Plane::in_camera(pose, {0.3, -0.2, 0}, {0, 0, -1});
    const auto shape = shape_on_plane(seen(corners), kCamera, plane);
    RC_ASSERT(shape.has_value());
    RC_ASSERT((shape->centroid - pose.translation()).norm() < 1e-9);
    RC_ASSERT(std::abs(shape->axes.col(0).dot(pose.linear().col(0))) > 1 - 1e-9);
    RC_ASSERT((shape->axes.col(2) - pose.linear().col(2)).norm() < 1e-9);
    RC_ASSERT(std::abs(shape->axes.determinant() - 1) < 1e-9);
    RC_ASSERT(shape->area > length * width);  // half a pixel further on all sides
  }));
}

TEST(Outline, ImpossibleOutlineHasNoShape) {
  const std::vector<Eigen::Vector2d> square{{300, 200}, {340, 200}, {340, 240}, {300, 240}};
  EXPECT_TRUE(shape_on_plane(square, kCamera, {Eigen::Vector3d::UnitZ(), 1}));
  EXPECT_FALSE(shape_on_plane(square, kCamera, {Eigen::Vector3d::UnitZ(), -1})) << "behind the camera";
  EXPECT_FALSE(shape_on_plane(square, kCamera, {Eigen::Vector3d::UnitY(), 0.5})) << "above the horizon";
  EXPECT_FALSE(shape_on_plane({{1, 1}, {2, 2}, {3, 3}}, kCamera, {Eigen::Vector3d::UnitZ(), 1})) << "no area";
}

TEST(SquarePose, ProjectedCornersGiveThePoseBack) {
  EXPECT_TRUE(rc::check([] {
    const Pose pose = any_pose();
    const double h = 0.03;
    const auto corners = seen({pose * Eigen::Vector3d(-h, h, 0), pose * Eigen::Vector3d(h, h, 0),
                               pose * Eigen::Vector3d(h, -h, 0), pose * Eigen::Vector3d(-h, -h, 0)});
    const auto found = square_pose(corners, 2 * h, kCamera);
    RC_ASSERT(found.has_value());
    RC_ASSERT((found->pose.translation() - pose.translation()).norm() < 1e-5);
    RC_ASSERT((found->pose.linear() - pose.linear()).norm() < 1e-3);
    RC_ASSERT(found->reprojection_error < 1e-3);
    RC_ASSERT(found->covariance.diagonal().minCoeff() > 0);
    // the error of a small square is largest along the view
    RC_ASSERT(found->covariance(2, 2) > found->covariance(0, 0));
  }));
}

TEST(Intrinsics, DistortionIsRemoved) {
  Intrinsics lens = kCamera;
  lens.distortion = {0.1, -0.05, 0.001, -0.002, 0.01};
  const Eigen::Vector2d ideal(500, 120);
  const double x = (ideal.x() - lens.cx) / lens.fx, y = (ideal.y() - lens.cy) / lens.fy, r2 = x * x + y * y;
  const auto& [k1, k2, p1, p2, k3] = lens.distortion;
  const double radial = 1 + k1 * r2 + k2 * r2 * r2 + k3 * r2 * r2 * r2;
  const Eigen::Vector2d distorted(lens.fx * (x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x)) + lens.cx,
                                  lens.fy * (y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y) + lens.cy);
  EXPECT_GT((distorted - ideal).norm(), 1);
  EXPECT_LT((lens.ideal({distorted})[0] - ideal).norm(), 0.01);
}

}  // namespace
}  // namespace mrroc::vsp::outline_test
