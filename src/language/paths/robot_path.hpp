#pragma once

#include <vector>

#include "mrroc/robot_command.hpp"
#include "mrroc/robot_state.hpp"

namespace mrroc {

/// The moving quantities of a robot on a path: position and orientation of its tool (rows 0..2, 3..5), its joints.
inline constexpr int kPathRows = 6 + kMaxJoints;
inline constexpr int kJointRow = 6;
using PathRow = Eigen::Matrix<double, kPathRows, 1>;

/// Derivatives by the path's parameter; those of the orientation are the angular rates.
struct PathRates {
  PathRow first = PathRow::Zero(), second = PathRow::Zero(), third = PathRow::Zero();
};

/// Limits of the norms of velocity, acceleration and jerk of some rows.
struct PathLimit {
  int row = 0, rows = 1;
  double velocity = 0, acceleration = 0, jerk = 0;
};

/// Limits of the parameter itself, 1/s and 1/s^2, where the robot does not move with it.
struct PathPace {
  double speed = 4, acceleration = 1000;
};

/// The path of one robot as a function of a parameter s: pieces, each from one of `breaks` to the next, without a
/// corner inside. PathTiming computes its timing, PathRunner commands it. Task's thread; methods but the constructor
/// and `joints` allocate nothing and never throw.
class RobotPath {
 public:
  virtual ~RobotPath() = default;

  /// The ends of the pieces: 0, ..., the length; ascending.
  const std::vector<double>& breaks() const noexcept { return breaks_; }
  /// The points where the robot comes to rest: 0 and the length are among them.
  const std::vector<double>& stops() const noexcept { return stops_; }
  /// The points that must not be skipped after an interruption: the stops are among them.
  const std::vector<double>& waypoints() const noexcept { return waypoints_; }
  const std::vector<PathLimit>& limits() const noexcept { return limits_; }
  const PathPace& pace() const noexcept { return pace_; }
  /// The parameter is the time, s: the path begins and ends at rest on its own.
  bool is_timed() const noexcept { return timed_; }
  double length() const noexcept { return breaks_.back(); }
  std::size_t piece_at(double s) const noexcept;

  virtual PathRates rates(std::size_t piece, double s) const noexcept = 0;
  virtual JointVector joints(double s) const noexcept = 0;
  /// Writes the robot's desired position, velocity and acceleration for s and its derivatives by time. Both 0: exactly
  /// at rest there.
  virtual void command(double s, double speed, double acceleration, RobotCommand& command) const noexcept = 0;

 protected:
  std::vector<double> breaks_{0}, stops_{0}, waypoints_{0};
  std::vector<PathLimit> limits_;
  PathPace pace_;
  bool timed_ = false;
};

/// The factor by which the path must be slower at s, with these derivatives of s by time, for its limits to hold: at
/// most 1 where they do. Velocity counts directly, acceleration by its root, jerk by its third root.
struct Excess {
  double factor = 0;
  std::size_t limit = 0;  ///< which
  ErrorCode code = ErrorCode::none;
};
Excess excess_of(const RobotPath& path, double s, double speed, double acceleration, double jerk) noexcept;

}  // namespace mrroc
