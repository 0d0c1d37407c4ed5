#pragma once

#include "mrroc/generators/path_generator.hpp"
#include "mrroc/generators/path_limits.hpp"

namespace mrroc {

/// The tool moves straight to a pose while it rotates about one axis, both together:
///   p(s) = p0 + s (p1 - p0),   R(s) = exp([s phi]) R0,   phi = log(R1 R0^T), below pi,   s of 0..1.
/// The speed is constant between jerk-limited ramps and is that of the slower of both. See PathGenerator for limits,
/// interruptions, and the start.
class CartesianLine : public PathGenerator {
 public:
  /// `target`: of the tool frame in the robot's base frame. Throws NonFatalError(invalid_argument): a pose that is not
  /// rigid, a limit that is not above 0.
  CartesianLine(Robot& robot, const Pose& target, const PathLimits& limits = {});

 private:
  std::unique_ptr<RobotPath> path_from(const JointVector& joints) override;

  Pose target_;
  PathLimits limits_;
};

}  // namespace mrroc
