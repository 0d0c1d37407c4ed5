#pragma once

#include <opencv2/aruco.hpp>

#include "sensors/camera/detection/detection.hpp"

namespace mrroc::vsp {

/// One ArUco marker of known size (S. Garrido-Jurado et al.: "Automatic generation and detection of highly reliable
/// fiducial markers under occlusion", Pattern Recognition 2014; OpenCV's aruco module), its corners refined by
/// `refine_square`. Its pose is the one of the two that fit a square (T. Collins, A. Bartoli: "Infinitesimal
/// plane-based pose estimation", IJCV 2014) with the smaller reprojection error, then refined. With J the corners'
/// derivative by position and rotation and s the standard deviation of a corner's coordinate, at least
/// kCornerDeviation:
///
///     covariance = s^2 (J^T J)^-1        s^2 = sum |corner - reprojected|^2 / (8 - 6)
///
/// When the other pose fits within kCornerDeviation as well, the marker is too small to decide between them:
/// rotation_deviation is then at least the half of the angle between both.
///
/// When the number is seen twice, the larger marker is taken.
class MarkerDetector final : public Detector {
 public:
  static constexpr double kCornerDeviation = 0.05;  ///< px

  /// `size`: side of the black square, m.
  MarkerDetector(cv::Ptr<cv::aruco::Dictionary> dictionary, int marker, double size);

  std::optional<Detection> find(const cv::Mat& picture, const Intrinsics& intrinsics,
                                const Pose& reference) const override;

 private:
  std::vector<Eigen::Vector2d> corners_in(const cv::Mat& picture) const;

  cv::Ptr<cv::aruco::Dictionary> dictionary_;
  cv::Ptr<cv::aruco::DetectorParameters> parameters_;
  int marker_;
  double size_;
};

/// Pose and covariance of a square of side `size`, m, whose corners are seen at `corners` (px, without distortion):
/// upper left, upper right, lower right, lower left in its own orientation. Empty when no pose fits.
std::optional<Detection> square_pose(const std::vector<Eigen::Vector2d>& corners, double size,
                                     const Intrinsics& intrinsics);

}  // namespace mrroc::vsp
