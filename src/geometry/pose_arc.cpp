#include "geometry/pose_arc.hpp"

#include "geometry/rigid_motion.hpp"

namespace mrroc {

PoseArc::PoseArc(const Pose& start, const Eigen::Vector3d& centre, const Eigen::Vector3d& axis, double angle,
                 const Eigen::Vector3d& turn, const Pose& end, double length)
    : start_(start), end_(end), centre_(centre), axis_(axis), angle_(angle), turn_(turn) {
  breaks_.push_back(length);
}

PathPose PoseArc::at(std::size_t /*piece*/, double s) const noexcept {
  const double length = breaks_.back();
  const double u = s / length;
  const Eigen::Vector3d arm = exp_rotation(u * angle_ * axis_) * (start_.translation() - centre_);
  const Eigen::Vector3d turning = axis_ * (angle_ / length);  // of the arm
  PathPose there;
  there.pose.translation() = centre_ + arm;
  there.pose.linear() = exp_rotation(u * turn_) * start_.linear();
  if (s <= 0) there.pose = start_;
  if (s >= length) there.pose = end_;
  there.first << turning.cross(arm), turn_ / length;
  there.second << turning.cross(turning.cross(arm)), Eigen::Vector3d::Zero();
  return there;
}

}  // namespace mrroc
