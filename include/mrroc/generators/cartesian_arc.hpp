#pragma once

#include <numbers>

#include "mrroc/generators/path_generator.hpp"
#include "mrroc/generators/path_limits.hpp"

namespace mrroc {

/// A rotation about an axis in the robot's base frame, by the right-hand rule.
struct Circle {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< any point of the axis, m
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();   ///< of any nonzero length
  double angle = 2 * std::numbers::pi;               ///< rad; negative: the opposite direction; may exceed one turn
  bool tool_turns = false;                           ///< with the circle; otherwise the tool keeps its orientation
};

/// The tool moves along a circular arc while it rotates about one axis in proportion. The speed is constant between
/// jerk-limited ramps and is that of the slower of both; on a circle of radius r it is at most sqrt(0.85 acceleration
/// r). See PathGenerator for limits, interruptions, and the start.
class CartesianArc : public PathGenerator {
 public:
  /// Through `via` (m, base frame) to `target`: position and orientation. Throws NonFatalError(invalid_argument): a
  /// number that is not finite, a pose that is not rigid, a limit that is not above 0; in `start()` when the three
  /// points lie on a line, or two of them are closer than a micrometre or than a thousandth of the longest distance
  /// between the points.
  CartesianArc(Robot& robot, const Eigen::Vector3d& via, const Pose& target, const PathLimits& limits = {});
  /// About an axis, from the tool's pose.
  CartesianArc(Robot& robot, const Circle& circle, const PathLimits& limits = {});

 private:
  std::unique_ptr<RobotPath> path_from(const JointVector& joints) override;

  bool through_;  ///< via to target; otherwise `circle_`
  Eigen::Vector3d via_ = Eigen::Vector3d::Zero();
  Pose target_ = Pose::Identity();
  Circle circle_;
  PathLimits limits_;
};

}  // namespace mrroc
