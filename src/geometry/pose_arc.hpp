#pragma once

#include "geometry/pose_path.hpp"

namespace mrroc {

/// An arc of a circle at a constant pace:
///   p(s) = c + exp([angle s / length] axis) (p0 - c),
/// while the tool rotates by the rotation vector `turn` s / length, in base axes. One piece. KDL's Path_Circle is the
/// same curve (the tests hold it against this one), but cannot rotate the tool by more than half a turn.
class PoseArc : public PosePath {
 public:
  /// `axis` of length 1. `end`: the pose that the numbers lead to but for rounding: where the path ends exactly.
  PoseArc(const Pose& start, const Eigen::Vector3d& centre, const Eigen::Vector3d& axis, double angle,
          const Eigen::Vector3d& turn, const Pose& end, double length);
  PathPose at(std::size_t piece, double s) const noexcept override;

 private:
  Pose start_, end_;
  Eigen::Vector3d centre_;
  Eigen::Vector3d axis_;
  double angle_;
  Eigen::Vector3d turn_;
};

}  // namespace mrroc
