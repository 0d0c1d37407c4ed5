#include "language/inverse_tools.hpp"

#include <cmath>

namespace mrroc {

double nearest_angle(double angle, double near, double period) noexcept {
  return near + std::remainder(angle - near, period);
}

bool is_rigid(const Pose& pose) noexcept {
  constexpr double kRotationError = 1e-6;
  const Eigen::Matrix3d r = pose.linear();
  // written so that a value that is not a number fails
  return pose.translation().allFinite() && (r.transpose() * r - Eigen::Matrix3d::Identity()).norm() < kRotationError &&
         r.determinant() > 0;
}

}  // namespace mrroc
