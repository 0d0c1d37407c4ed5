#include "language/cooperation/internal_wrench.hpp"

#include <Eigen/LU>

namespace mrroc {

InternalWrench::InternalWrench(const std::vector<Eigen::Vector3d>& grasps, double length) : arms_(grasps) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& grasp : grasps) middle += grasp / static_cast<double>(grasps.size());
  const auto size = static_cast<Eigen::Index>(6 * grasps.size());
  Eigen::MatrixXd w = Eigen::MatrixXd::Zero(6, size);
  for (std::size_t i = 0; i < grasps.size(); ++i) {
    Eigen::Vector3d& r = arms_[i];
    r -= middle;
    auto part = w.middleCols<6>(static_cast<Eigen::Index>(6 * i));
    part.setIdentity();
    part.bottomLeftCorner<3, 3>() << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
    part.bottomLeftCorner<3, 3>() /= length;
  }
  const Eigen::Matrix<double, 6, 6> total = w * w.transpose();
  matrix_ = Eigen::MatrixXd::Identity(size, size) - w.transpose() * total.inverse() * w;
}

Eigen::VectorXd InternalWrench::squeeze(double force) const {
  Eigen::VectorXd outward = Eigen::VectorXd::Zero(matrix_.rows());
  for (std::size_t i = 0; i < arms_.size(); ++i) {
    if (arms_[i].norm() > 0) outward.segment<3>(static_cast<Eigen::Index>(6 * i)) = force * arms_[i].normalized();
  }
  return matrix_ * outward;
}

}  // namespace mrroc
