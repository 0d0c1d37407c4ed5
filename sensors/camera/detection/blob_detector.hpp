#pragma once

#include <array>

#include "sensors/camera/detection/detection.hpp"

namespace mrroc::vsp {

/// Bounds of a colour: hue in degrees, from..to, through 0 when from > to; saturation and value 0..1.
struct ColourRange {
  std::array<double, 2> hue{0, 360};
  std::array<double, 2> saturation{0, 1};
  std::array<double, 2> value{0, 1};
};

/// The largest spot of one colour, measured on a known plane (`shape_on_plane`). A spot that touches the picture's
/// border is ignored, because its centroid is unknown; so are those of less than `min_area` pixels and those that
/// cannot lie on the plane. Holes do not count. Of the two directions of the greatest extent the pose's x axis is the
/// one nearer to the x axis of the reference frame.
class BlobDetector final : public Detector {
 public:
  /// `point`, `normal`: the plane in the reference frame.
  BlobDetector(const ColourRange& colour, double min_area, const Eigen::Vector3d& point, const Eigen::Vector3d& normal)
      : colour_(colour), min_area_(min_area), point_(point), normal_(normal) {}

  std::optional<Detection> find(const cv::Mat& picture, const Intrinsics& intrinsics,
                                const Pose& reference) const override;
  std::string_view obstacle(const Intrinsics& intrinsics, const Pose& reference) const override;

 private:
  cv::Mat mask_of(const cv::Mat& picture) const;

  ColourRange colour_;
  double min_area_;
  Eigen::Vector3d point_;
  Eigen::Vector3d normal_;
};

}  // namespace mrroc::vsp
