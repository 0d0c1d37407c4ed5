#pragma once

#include <vector>

#include "mrroc/generators/path_generator.hpp"

namespace mrroc {

/// Through waypoints in joint space without stopping: a cubic spline from the desired joints through all of them, with
/// continuous velocity and acceleration, under the robot's velocity, acceleration and jerk limits scaled by `speed`,
/// speed^2, speed^3. At rest at the start and in the last waypoint.
///
/// The spline's parameter is the time from waypoint to waypoint at full speed (of the slowest joint). The spline stays
/// within the position limits: where it would overshoot, the joint's tangents are flattened; waypoints at a limit are
/// passed some microradians inside (src/language/joints/joint_spline.hpp). See PathGenerator for limits and
/// interruptions.
class JointPath : public PathGenerator {
 public:
  /// Joint positions, rad or m. Waypoints that differ by less than 1e-4 in every joint are merged; the last one is
  /// always kept. `speed` in [1e-6, 1]. Throws NonFatalError: invalid_argument (no waypoint, size, speed), not_finite,
  /// joint_limit.
  JointPath(Robot& robot, std::vector<JointVector> waypoints, double speed = 0.5);
  /// Tool poses in the robot's base frame, each as the posture nearest to the one before, as JointLine chooses it.
  /// `start()` throws NonFatalError: motor_limit; for poses also out_of_workspace, joint_limit.
  JointPath(Robot& robot, const std::vector<Pose>& waypoints, double speed = 0.5);

 private:
  std::unique_ptr<RobotPath> path_from(const JointVector& joints) override;

  std::vector<JointVector> waypoints_;
  std::vector<Pose> poses_;  ///< used instead, if not empty
  double speed_;
};

}  // namespace mrroc
