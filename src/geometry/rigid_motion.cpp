#include "geometry/rigid_motion.hpp"

#include <cmath>

namespace mrroc {

namespace {

bool is_rigid_within(const Pose& pose, double tolerance) noexcept {
  const Eigen::Matrix3d r = pose.linear();
  // written so that a value that is not a number fails
  return pose.translation().allFinite() && (r.transpose() * r - Eigen::Matrix3d::Identity()).norm() < tolerance &&
         r.determinant() > 0;
}

}  // namespace

bool is_rigid(const Pose& pose) noexcept { return is_rigid_within(pose, 1e-6); }

bool make_rigid(Pose& pose) noexcept {
  constexpr double kMeasured = 5e-3;
  if (is_rigid(pose)) return true;
  if (!is_rigid_within(pose, kMeasured)) return false;
  pose.linear() = orthonormal(pose.linear());
  return true;
}

Pose pose_from_rpy(const Eigen::Vector3d& position, const Eigen::Vector3d& turns) noexcept {
  Pose frame = Pose::Identity();
  frame.translation() = position;
  // turns about fixed axes: the last one is the leftmost factor
  frame.linear() =
      (Eigen::AngleAxisd(turns.z(), Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(turns.y(), Eigen::Vector3d::UnitY()) *
       Eigen::AngleAxisd(turns.x(), Eigen::Vector3d::UnitX()))
          .toRotationMatrix();
  return frame;
}

Eigen::Vector3d rpy_of(const Eigen::Matrix3d& rotation) noexcept {
  // any yaw is right where the pitch is +-pi/2: roll and pitch are those of the rotation that remains
  const double yaw = std::atan2(rotation(1, 0), rotation(0, 0));
  const Eigen::Matrix3d rest = Eigen::AngleAxisd(-yaw, Eigen::Vector3d::UnitZ()) * rotation;
  return {std::atan2(-rest(1, 2), rest(1, 1)), std::atan2(-rest(2, 0), rest(0, 0)), yaw};
}

Twist rotate_twist(const Eigen::Matrix3d& rotation, const Twist& twist) noexcept {
  Twist result;
  result << rotation * twist.head<3>(), rotation * twist.tail<3>();
  return result;
}

Pose exp_twist(const Twist& displacement) noexcept {
  const Eigen::Vector3d linear = displacement.head<3>();
  const Eigen::Vector3d angular = displacement.tail<3>();
  Pose pose = Pose::Identity();
  const double angle = angular.norm();
  if (angle < 1e-12) {
    pose.translation() = linear;
    return pose;
  }
  const Eigen::Vector3d axis = angular / angle;
  pose.linear() = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
  const Eigen::Vector3d v = linear / angle;
  pose.translation() =
      v * angle + (1 - std::cos(angle)) * axis.cross(v) + (angle - std::sin(angle)) * axis.cross(axis.cross(v));
  return pose;
}

Eigen::Matrix3d exp_rotation(const Eigen::Vector3d& vector) noexcept {
  const double angle = vector.norm();
  if (angle < 1e-150) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, vector / angle).toRotationMatrix();
}

Eigen::Vector3d rotation_vector(const Eigen::Matrix3d& rotation) noexcept {
  const Eigen::Quaterniond q(rotation);
  const double sine = q.vec().norm();  // of half the angle
  const double angle = 2 * std::atan2(sine, std::abs(q.w()));
  const double factor = sine < 1e-150 ? 2 : angle / sine;
  return std::copysign(factor, q.w()) * q.vec();
}

Eigen::Matrix3d orthonormal(const Eigen::Matrix3d& rotation) noexcept {
  return Eigen::Quaterniond(rotation).normalized().toRotationMatrix();
}

}  // namespace mrroc
