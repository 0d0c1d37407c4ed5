#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace mrroc::vsp {

/// Corners of a black square with a white margin, to some hundredths of a pixel: the lines through its sides, fitted to
/// where the brightness along their normals changes (the centre of its gradient), meet there (as in J. Wang, E. Olson:
/// "AprilTag 2", IROS 2016). A corner's own neighbourhood, which a blur rounds off, does not count.
///
/// `grey`: 8 bits. `corners`: of the square, clockwise in the picture, to a pixel. `cell`: width in which black and
/// white next to the sides are plain, px. A side without an edge leaves the corners unchanged.
std::vector<Eigen::Vector2d> refine_square(const cv::Mat& grey, const std::vector<Eigen::Vector2d>& corners,
                                           double cell);

}  // namespace mrroc::vsp
