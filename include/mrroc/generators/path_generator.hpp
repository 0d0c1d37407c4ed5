#pragma once

#include <memory>

#include "mrroc/generator.hpp"
#include "mrroc/robot.hpp"

namespace mrroc {

class PathRunner;
class RobotPath;

/// What the generators that go along a path have in common: JointPath, PoseSpline, CartesianLine, CartesianArc,
/// BlendedPath. The shape of the path is fixed in `start()`; then it is planned when the robot is where, under all
/// limits together:
///
/// - The tool's, where the generator has PathLimits, and the joints': 0.99 of the velocity, 0.9 of the acceleration and
///   0.45 of the jerk limits, as JointLine (the EDP's polynomials overshoot a little). They hold all along the path; it
///   is slower only where it has to be. Nearly time-optimal: src/language/paths/path_timing.hpp.
/// - The joints are followed through the inverse kinematics before anything moves: a path that leaves the workspace, a
///   joint's or a motor's range, or meets a singularity, is refused by `start()`: NonFatalError (out_of_workspace,
///   joint_limit, motor_limit, singular) with the place.
///
/// It begins at the desired state. From a motion under way the robot first comes to rest, within its limits, and the
/// path begins there. It ends on its own when the last macrostep has been commanded: at rest, exactly at the last pose.
///
/// A pause brings the robot to rest on its path, within all limits, and it continues along the rest from there. After a
/// late command, or a pause on the way to the path, it stands beside it, since such a stop brakes each joint on its
/// own: it is led straight in joint space to the nearest point of the path, not beyond the next waypoint, and goes
/// along the rest from there, from rest.
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

  /// Seconds that the whole motion takes, in whole macrosteps; after `start()`, and again after `resume()`.
  double duration() const noexcept;

 protected:
  PathGenerator(Robot& robot, std::string name);
  /// The path from `joints` on, where the robot rests then; null when there is no way to go.
  virtual std::unique_ptr<RobotPath> path_from(const JointVector& joints) = 0;
  Robot& robot() const noexcept { return *robot_; }

 private:
  Robot* robot_;
  std::unique_ptr<PathRunner> runner_;
};

}  // namespace mrroc
