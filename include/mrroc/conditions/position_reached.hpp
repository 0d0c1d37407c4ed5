#pragma once

#include <limits>

#include "mrroc/condition.hpp"
#include "mrroc/robot.hpp"

namespace mrroc {

/// The tool's measured position is within `tolerance` (m) of a position in the robot's base frame; with a pose, its
/// orientation is also within `angle` (rad) of the pose's.
class PositionReached : public Condition {
 public:
  /// Throw NonFatalError: not_finite, invalid_argument unless the tolerances are above 0 and the pose is rigid.
  PositionReached(const Robot& robot, const Eigen::Vector3d& position, double tolerance);
  PositionReached(const Robot& robot, const Pose& pose, double tolerance, double angle);

 protected:
  bool holds() override;

 private:
  const Robot* robot_;
  Pose pose_ = Pose::Identity();
  double tolerance_;
  double angle_ = std::numeric_limits<double>::infinity();
};

/// Every measured joint is within `tolerance` (rad or m) of a joint position.
class JointsReached : public Condition {
 public:
  /// Throws NonFatalError: not_finite, invalid_argument unless the tolerance is above 0 and there is one value for each
  /// axis of the robot.
  JointsReached(const Robot& robot, const JointVector& joints, double tolerance);

 protected:
  bool holds() override;

 private:
  const Robot* robot_;
  JointVector joints_;
  double tolerance_;
};

}  // namespace mrroc
