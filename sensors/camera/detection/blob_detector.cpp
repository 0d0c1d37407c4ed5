#include "sensors/camera/detection/blob_detector.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "sensors/camera/detection/outline.hpp"

namespace mrroc::vsp {

namespace {

/// A camera nearer to the plane than this, m, lies in it.
constexpr double kInPlane = 1e-6;

bool touches_border(const cv::Rect& box, const cv::Mat& picture) {
  return box.x == 0 || box.y == 0 || box.x + box.width == picture.cols || box.y + box.height == picture.rows;
}

/// Pixels of a spot with this outline (Pick's theorem).
double pixels_of(const std::vector<cv::Point>& contour) {
  return cv::contourArea(contour) + static_cast<double>(contour.size()) / 2 + 1;
}

std::vector<Eigen::Vector2d> points_of(const std::vector<cv::Point>& contour) {
  std::vector<Eigen::Vector2d> points;
  points.reserve(contour.size());
  for (const cv::Point& point : contour) points.emplace_back(point.x, point.y);
  return points;
}

Detection detection_of(const FlatShape& shape, const Intrinsics& intrinsics, const Pose& reference) {
  Detection found;
  found.pose.translation() = shape.centroid;
  found.pose.linear() = shape.axes;
  if (shape.axes.col(0).dot(reference.linear().col(0)) < 0) found.pose.linear().leftCols<2>() *= -1;
  found.covariance = shape.covariance;
  found.rotation_deviation = shape.rotation_deviation;
  found.pixel = intrinsics.project(shape.centroid);
  found.area = shape.area;
  return found;
}

}  // namespace

cv::Mat BlobDetector::mask_of(const cv::Mat& picture) const {
  cv::Mat hsv, mask;
  cv::cvtColor(picture, hsv, cv::COLOR_RGB2HSV_FULL);  // a full turn of the hue is 256
  const auto bound = [this](double hue, std::size_t end) {
    return cv::Scalar(std::round(hue * 256 / 360), std::round(255 * colour_.saturation[end]),
                      std::round(255 * colour_.value[end]));
  };
  const auto& [from, to] = colour_.hue;
  if (from <= to) {
    cv::inRange(hsv, bound(from, 0), bound(to, 1), mask);
  } else {
    cv::Mat beyond_zero;
    cv::inRange(hsv, bound(from, 0), bound(360, 1), mask);
    cv::inRange(hsv, bound(0, 0), bound(to, 1), beyond_zero);
    mask |= beyond_zero;
  }
  return mask;
}

std::optional<Detection> BlobDetector::find(const cv::Mat& picture, const Intrinsics& intrinsics,
                                            const Pose& reference) const {
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(mask_of(picture), contours, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
  std::erase_if(contours, [&](const auto& contour) {
    return pixels_of(contour) < min_area_ || touches_border(cv::boundingRect(contour), picture);
  });
  std::sort(contours.begin(), contours.end(),
            [](const auto& a, const auto& b) { return cv::contourArea(a) > cv::contourArea(b); });
  const Plane plane = Plane::in_camera(reference, point_, normal_);
  for (const auto& contour : contours) {
    const std::vector<Eigen::Vector2d> outline = points_of(contour);
    const auto shape = shape_on_plane(intrinsics.ideal(outline), intrinsics, plane);
    if (!shape) continue;
    Detection found = detection_of(*shape, intrinsics, reference);
    found.outline = outline;
    return found;
  }
  return std::nullopt;
}

std::string_view BlobDetector::obstacle(const Intrinsics& intrinsics, const Pose& reference) const {
  const Plane plane = Plane::in_camera(reference, point_, normal_);
  if (std::abs(plane.distance) < kInPlane) return "the camera lies in the plane and sees it edge on";
  for (const double u : {0.0, intrinsics.width - 1.0}) {
    for (const double v : {0.0, intrinsics.height - 1.0}) {
      if (plane.distance / plane.normal.dot(intrinsics.ray({u, v})) > 0) return {};
    }
  }
  return "the plane is parallel to the view or behind the camera: no pixel sees it";
}

}  // namespace mrroc::vsp
