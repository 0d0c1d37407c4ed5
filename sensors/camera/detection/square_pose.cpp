#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/calib3d.hpp>

#include "sensors/camera/detection/marker_detector.hpp"

namespace mrroc::vsp {

namespace {

using Corners = std::array<Eigen::Vector3d, 4>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

Corners corners_of(double size) {
  const double h = size / 2;
  return {Eigen::Vector3d{-h, h, 0}, {h, h, 0}, {h, -h, 0}, {-h, -h, 0}};
}

Pose pose_of(const cv::Mat& turn, const cv::Mat& position) {
  const Eigen::Vector3d vector(turn.at<double>(0), turn.at<double>(1), turn.at<double>(2));
  Pose pose = Pose::Identity();
  if (vector.norm() > 0) pose.linear() = Eigen::AngleAxisd(vector.norm(), vector.normalized()).toRotationMatrix();
  pose.translation() << position.at<double>(0), position.at<double>(1), position.at<double>(2);
  return pose;
}

double squared_error(const Pose& pose, const std::vector<Eigen::Vector2d>& seen, const Corners& corners,
                     const Intrinsics& intrinsics) {
  double sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    sum += (intrinsics.project(pose * corners[i]) - seen[i]).squaredNorm();
  return sum;
}

/// J^T J of the corners' pixels by position and by a small turn about the camera's axes.
Matrix6d information(const Pose& pose, const Corners& corners, const Intrinsics& intrinsics) {
  Matrix6d sum = Matrix6d::Zero();
  for (const Eigen::Vector3d& corner : corners) {
    const Eigen::Vector3d arm = pose.linear() * corner;
    const Eigen::Vector3d p = pose.translation() + arm;
    Eigen::Matrix<double, 2, 3> by_point;
    by_point << intrinsics.fx / p.z(), 0, -intrinsics.fx * p.x() / (p.z() * p.z()), 0, intrinsics.fy / p.z(),
        -intrinsics.fy * p.y() / (p.z() * p.z());
    Eigen::Matrix3d by_turn;  // of the point: turn x arm
    by_turn << 0, arm.z(), -arm.y(), -arm.z(), 0, arm.x(), arm.y(), -arm.x(), 0;
    Eigen::Matrix<double, 2, 6> jacobian;
    jacobian << by_point, by_point * by_turn;
    sum += jacobian.transpose() * jacobian;
  }
  return sum;
}

}  // namespace

std::optional<Detection> square_pose(const std::vector<Eigen::Vector2d>& corners, double size,
                                     const Intrinsics& intrinsics) {
  const Corners square = corners_of(size);
  std::vector<cv::Point3d> object;
  std::vector<cv::Point2d> image;
  for (std::size_t i = 0; i < square.size(); ++i) {
    object.emplace_back(square[i].x(), square[i].y(), square[i].z());
    image.emplace_back(corners[i].x(), corners[i].y());
  }
  const cv::Matx33d matrix(intrinsics.fx, 0, intrinsics.cx, 0, intrinsics.fy, intrinsics.cy, 0, 0, 1);
  std::vector<cv::Mat> turns, positions;
  cv::solvePnPGeneric(object, image, matrix, cv::noArray(), turns, positions, false, cv::SOLVEPNP_IPPE_SQUARE);
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    cv::solvePnPRefineLM(object, image, matrix, cv::noArray(), turns[i], positions[i]);
    const Pose pose = pose_of(turns[i], positions[i]);
    if (pose.matrix().allFinite() && pose.translation().z() > 0) poses.push_back(pose);
  }
  if (poses.empty()) return std::nullopt;
  const auto error = [&](const Pose& pose) { return squared_error(pose, corners, square, intrinsics); };
  std::sort(poses.begin(), poses.end(), [&](const Pose& a, const Pose& b) { return error(a) < error(b); });

  Detection found;
  found.pose = poses.front();
  const double residue = error(found.pose);
  found.reprojection_error = std::sqrt(residue / 4);
  const double variance = std::max(residue / 2, MarkerDetector::kCornerDeviation * MarkerDetector::kCornerDeviation);
  const Matrix6d covariance = variance * information(found.pose, square, intrinsics).ldlt().solve(Matrix6d::Identity());
  found.covariance = covariance.topLeftCorner<3, 3>();
  found.rotation_deviation = std::sqrt(covariance.bottomRightCorner<3, 3>().diagonal().maxCoeff());
  if (poses.size() > 1 &&
      std::sqrt(error(poses[1]) / 4) < found.reprojection_error + MarkerDetector::kCornerDeviation) {
    const Eigen::AngleAxisd between(Eigen::Matrix3d(poses[0].linear().transpose() * poses[1].linear()));
    found.rotation_deviation = std::max(found.rotation_deviation, std::abs(between.angle()) / 2);
  }
  found.pixel = intrinsics.project(found.pose.translation());
  found.area = size * size;
  return found;
}

}  // namespace mrroc::vsp
