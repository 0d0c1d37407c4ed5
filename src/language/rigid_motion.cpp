#include "language/rigid_motion.hpp"

namespace mrroc {

bool is_rigid(const Pose& pose) noexcept {
  constexpr double kRotationError = 1e-6;
  const Eigen::Matrix3d r = pose.linear();
  // written so that a value that is not a number fails
  return pose.translation().allFinite() && (r.transpose() * r - Eigen::Matrix3d::Identity()).norm() < kRotationError &&
         r.determinant() > 0;
}

Pose frame_at(const Eigen::Vector3d& position, const Eigen::Vector3d& turns) noexcept {
  Pose frame = Pose::Identity();
  frame.translation() = position;
  // turns about fixed axes: the last one is the leftmost factor
  frame.linear() =
      (Eigen::AngleAxisd(turns.z(), Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(turns.y(), Eigen::Vector3d::UnitY()) *
       Eigen::AngleAxisd(turns.x(), Eigen::Vector3d::UnitX()))
          .toRotationMatrix();
  return frame;
}

Twist turned(const Eigen::Matrix3d& rotation, const Twist& twist) noexcept {
  Twist result;
  result << rotation * twist.head<3>(), rotation * twist.tail<3>();
  return result;
}

}  // namespace mrroc
