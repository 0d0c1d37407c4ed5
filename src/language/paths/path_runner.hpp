#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "language/motion_check.hpp"
#include "language/paths/path_brake.hpp"
#include "language/paths/path_timing.hpp"
#include "mrroc/generators/joint_line.hpp"
#include "mrroc/robot.hpp"

namespace mrroc {

/// Moves a robot along a RobotPath, for generators: from stop to stop with PathTiming, each stop at the end of a
/// macrostep. Task's thread; `step`, `over` and `brake` allocate nothing.
class PathRunner {
 public:
  explicit PathRunner(Robot& robot) : robot_(&robot) {}

  /// Begins a new motion and returns the joints at which its path must begin: the robot's desired joints, or for a
  /// moving robot those at which it comes to rest, which is commanded first. Throws NonFatalError when its state is
  /// unknown.
  JointVector begin();
  /// Sets the path of the motion. Throws NonFatalError when it is timed and too fast (velocity_limit,
  /// acceleration_limit, jerk_limit); the error with which the EDP would refuse the motion (MotionCheck).
  void follow(std::unique_ptr<RobotPath> path);
  /// Brings the robot to rest on the path, until `resume`. False when it is not on the path, or when this is
  /// impossible.
  bool brake() noexcept;
  /// Continues after the robot has come to rest, on the path or beside it: straight in joint space to the nearest point
  /// (in joint space, in time at full speed) between the last stop and the next waypoint, and from there along the rest
  /// of the path.
  void resume();

  bool over() const noexcept { return !leading_ && next_ == timings_.size(); }
  void step();

  /// Of the whole motion that was planned last, s.
  double duration() const noexcept { return duration_; }

 private:
  void check_times() const;
  void plan_from(double s);
  void check_limits(PathTiming& timing);
  /// By samples, with a reserve for the motion between them.
  MotionPace pace_of(const PathTiming& timing) const;
  DesiredState state(const PathTiming& timing, double time) const;
  /// Adds a timing, or two with a rest between them if that takes less time, recursively.
  void add(PathTiming timing, int more_rests);
  double nearest_point() const;
  /// From the robot's desired joints to those at s, in seconds at full speed.
  double distance(double s) const;
  void step_of_brake() noexcept;
  void lead_to(const JointVector& joints, double speed);
  double whole_steps(double duration) const noexcept;

  Robot* robot_;
  std::unique_ptr<RobotPath> path_;
  std::optional<MotionCheck> check_;
  std::vector<PathTiming> timings_;  ///< from stop to stop
  std::size_t next_ = 0;             ///< of the timings
  double time_ = 0;                  ///< in it, at the end of what has been commanded
  double place_ = 0;                 ///< on the path, there
  std::optional<JointLine> lead_;    ///< to the point where the path continues
  bool leading_ = false;
  std::optional<PathBrake> brake_;
  double braked_ = 0;     ///< time in it, at the end of what has been commanded
  bool halting_ = false;  ///< to rest at the next stop
  double duration_ = 0;
};

}  // namespace mrroc
