#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <vector>

#include "mrroc/types.hpp"
#include "sensors/camera/intrinsics.hpp"

namespace mrroc::vsp {

/// The detection in one picture, in the camera frame (z along the view, x right, y down).
struct Detection {
  Pose pose = Pose::Identity();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of the position, m^2
  double rotation_deviation = 0;                         ///< rad
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();       ///< of the position, without distortion
  double reprojection_error = 0;                         ///< px
  double area = 0;                                       ///< m^2
  std::vector<Eigen::Vector2d> outline;                  ///< in the picture as it is, px
};

/// A plane n . p = d in the camera frame, |n| = 1.
struct Plane {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double distance = 0;

  /// `pose`: of the frame that the plane is given in, in the camera frame.
  static Plane in_camera(const Pose& pose, const Eigen::Vector3d& point, const Eigen::Vector3d& normal) {
    const Eigen::Vector3d n = (pose.linear() * normal).normalized();
    return {n, n.dot(pose * point)};
  }
};

/// Finds one object in pictures. One thread; it allocates, as OpenCV does.
class Detector {
 public:
  virtual ~Detector() = default;
  /// `picture`: 8-bit RGB of the size of `intrinsics`. `reference`: pose of the reading's frame in the camera frame.
  /// Throws cv::Exception.
  virtual std::optional<Detection> find(const cv::Mat& picture, const Intrinsics& intrinsics,
                                        const Pose& reference) const = 0;
  /// Why a camera with this pose of its reference frame can never find anything; empty when it can.
  virtual std::string_view obstacle(const Intrinsics& /*intrinsics*/, const Pose& /*reference*/) const { return {}; }
};

}  // namespace mrroc::vsp
