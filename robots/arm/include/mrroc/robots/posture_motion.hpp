#pragma once

#include "mrroc/generators/path_generator.hpp"

namespace mrroc {

/// Motion of a redundant robot toward joints `wished` that leaves its flange where it is. From the joints q at the
/// start it descends the cost H(q) = |q - wished|^2 / 2 (rad, m) in the null space of the Jacobian J,
///
///   dq = (I - J^+ J) (wished - q),
///
/// each step corrected by the inverse kinematics to the flange pose of the start, and ends where dq disappears, or
/// where a joint or its motor meets a limit. Along the steps it is a JointPath: same limits, pause and interruptions. A
/// robot without redundancy does not move.
class PostureMotion : public PathGenerator {
 public:
  /// `wished`: rad or m. `speed` in [1e-6, 1], as of a JointPath. Throws NonFatalError: invalid_argument (size, speed),
  /// not_finite, joint_limit.
  PostureMotion(Robot& robot, const JointVector& wished, double speed = 0.5);

 private:
  std::unique_ptr<RobotPath> path_from(const JointVector& joints) override;

  JointVector wished_;
  double speed_;
};

}  // namespace mrroc
