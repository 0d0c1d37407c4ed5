#pragma once

#include <memory>

#include "mrroc/generator.hpp"
#include "mrroc/robot.hpp"

namespace mrroc {

class PathRunner;
class RobotPath;

/// Base class of the generators that follow a path: JointPath, PoseSpline, CartesianLine, CartesianArc, BlendedPath.
/// `start()` fixes the shape of the path, then plans the timing along it under all limits together:
///
/// - The tool's limits, where the generator has PathLimits, and the joints': 0.99 of the velocity, 0.9 of the
///   acceleration and 0.45 of the jerk limits, as JointLine (the EDP's polynomials overshoot a little). They hold along
///   the whole path; the motion is slower only where necessary. Nearly time-optimal:
///   src/language/paths/path_timing.hpp.
/// - `start()` computes the joints by the inverse kinematics before anything moves. It refuses a path that leaves the
///   workspace, a joint's or a motor's range, or meets a singularity: NonFatalError (out_of_workspace, joint_limit,
///   motor_limit, singular) with the position on the path.
///
/// The path begins at the desired state. A moving robot first comes to rest within its limits, and the path begins
/// there. The motion ends on its own when the last macrostep has been commanded: at rest, exactly at the last pose.
///
/// A pause brings the robot to rest on its path, within all limits, and it continues from there. A late command, or a
/// pause before the path is reached, stops each joint on its own, beside the path. The robot then moves straight in
/// joint space to the nearest point of the path, not beyond the next waypoint, and continues from there, from rest.
///
/// Poses are commanded with twist and twist rate, joints with velocity and acceleration. Planning takes some
/// milliseconds, in `start()` and `resume()`; a step allocates nothing.
class PathGenerator : public Generator {
 public:
  ~PathGenerator() override;
  PathGenerator(PathGenerator&&) noexcept;
  PathGenerator& operator=(PathGenerator&&) noexcept;

  void start() override;
  void resume() override;
  bool brake() override;
  bool terminal_condition() override;
  void next_state() override;

  /// Duration of the whole motion, s, in whole macrosteps; after `start()`, and again after `resume()`.
  double duration() const noexcept;

 protected:
  PathGenerator(Robot& robot, std::string name);
  /// The path from `joints` on, where the robot rests then; null when its length is 0.
  virtual std::unique_ptr<RobotPath> path_from(const JointVector& joints) = 0;
  Robot& robot() const noexcept { return *robot_; }

 private:
  Robot* robot_;
  std::unique_ptr<PathRunner> runner_;
};

}  // namespace mrroc
