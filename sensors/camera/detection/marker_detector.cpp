#include "sensors/camera/detection/marker_detector.hpp"

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "sensors/camera/detection/square_edges.hpp"

namespace mrroc::vsp {

MarkerDetector::MarkerDetector(cv::Ptr<cv::aruco::Dictionary> dictionary, int marker, double size)
    : dictionary_(std::move(dictionary)),
      parameters_(cv::aruco::DetectorParameters::create()),
      marker_(marker),
      size_(size) {
  parameters_->cornerRefinementMethod = cv::aruco::CORNER_REFINE_SUBPIX;
}

/// Four corners of the marker, or none.
std::vector<Eigen::Vector2d> MarkerDetector::corners_in(const cv::Mat& picture) const {
  cv::Mat grey;
  cv::cvtColor(picture, grey, cv::COLOR_RGB2GRAY);
  std::vector<std::vector<cv::Point2f>> all;
  std::vector<int> numbers;
  cv::aruco::detectMarkers(grey, dictionary_, all, numbers, parameters_);
  std::vector<Eigen::Vector2d> corners;
  double area = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (numbers[i] != marker_ || cv::contourArea(all[i]) <= area) continue;
    area = cv::contourArea(all[i]);
    corners.clear();
    for (const cv::Point2f& corner : all[i]) corners.emplace_back(corner.x, corner.y);
  }
  if (corners.empty()) return corners;
  const double cell = std::sqrt(area) / (dictionary_->markerSize + 2);
  return refine_square(grey, corners, cell);
}

std::optional<Detection> MarkerDetector::find(const cv::Mat& picture, const Intrinsics& intrinsics,
                                              const Pose& /*reference*/) const {
  std::vector<Eigen::Vector2d> corners = corners_in(picture);
  if (corners.empty()) return std::nullopt;
  std::optional<Detection> found = square_pose(intrinsics.ideal(corners), size_, intrinsics);
  if (found) found->outline = std::move(corners);
  return found;
}

}  // namespace mrroc::vsp
