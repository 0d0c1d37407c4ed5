#pragma once

#include <vector>

#include "mrroc/robot_command.hpp"
#include "mrroc/robot_state.hpp"

namespace mrroc {

/// What of a robot moves along a path: position and orientation of its tool (rows 0..2, 3..5), its joints.
inline constexpr int kPathRows = 6 + kMaxJoints;
inline constexpr int kJointRow = 6;
using PathRow = Eigen::Matrix<double, kPathRows, 1>;

/// Derivatives by the path's parameter; of the orientation they are those of the turning.
struct PathRates {
  PathRow first = PathRow::Zero(), second = PathRow::Zero(), third = PathRow::Zero();
};

/// What the norm of velocity, acceleration and jerk of some rows may be.
struct PathLimit {
  int row = 0, rows = 1;
  double velocity = 0, acceleration = 0, jerk = 0;
};

/// How fast the parameter itself may change, 1/s and 1/s^2: where nothing of the robot moves with it.
struct PathPace {
  double speed = 4, acceleration = 1000;
};

/// The way of one robot as a function of a parameter s: pieces, each from one of `breaks` to the next, without a corner
/// inside. PathTiming says when it is where, PathRunner commands it. Task's thread; methods but the constructor and
/// `joints` allocate nothing and never throw.
class RobotPath {
 public:
  virtual ~RobotPath() = default;

  /// Where pieces begin and end: 0, ..., the length; ascending.
  const std::vector<double>& breaks() const noexcept { return breaks_; }
  /// Where the robot comes to rest on the way: 0 and the length are among them.
  const std::vector<double>& stops() const noexcept { return stops_; }
  /// What must not be left out after an interruption: the stops are among them.
  const std::vector<double>& waypoints() const noexcept { return waypoints_; }
  const std::vector<PathLimit>& limits() const noexcept { return limits_; }
  const PathPace& pace() const noexcept { return pace_; }
  /// The parameter is the time, s: the path begins and ends at rest on its own.
  bool is_timed() const noexcept { return timed_; }
  double length() const noexcept { return breaks_.back(); }
  std::size_t piece_at(double s) const noexcept;

  virtual PathRates rates(std::size_t piece, double s) const noexcept = 0;
  virtual JointVector joints(double s) const noexcept = 0;
  /// Writes where the robot is to be with which velocity and acceleration, for s and its derivatives by time. Both 0:
  /// at rest exactly there.
  virtual void command(double s, double speed, double acceleration, RobotCommand& command) const noexcept = 0;

 protected:
  std::vector<double> breaks_{0}, stops_{0}, waypoints_{0};
  std::vector<PathLimit> limits_;
  PathPace pace_;
  bool timed_ = false;
};

/// How much slower the path would have to be at s, with these derivatives of s by time, for its limits to hold: at most
/// 1 where they do. Velocity counts as it is, acceleration by its root, jerk by its third root.
struct Excess {
  double factor = 0;
  std::size_t limit = 0;  ///< which
  ErrorCode code = ErrorCode::none;
};
Excess excess_of(const RobotPath& path, double s, double speed, double acceleration, double jerk) noexcept;

}  // namespace mrroc
