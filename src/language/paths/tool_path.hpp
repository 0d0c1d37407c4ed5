#pragma once

#include <memory>

#include "geometry/pose_path.hpp"
#include "language/paths/robot_path.hpp"
#include "mrroc/generators/path_limits.hpp"
#include "mrroc/robot.hpp"

namespace mrroc {

/// Throw NonFatalError(invalid_argument), `name` first: unless all limits are finite and above 0; unless the pose is a
/// rigid motion. The pose is returned with its rotation made exact.
void check_limits(const PathLimits& limits, const char* name);
Pose checked_pose(const Pose& pose, const char* name);

/// A path of a robot's tool: the joints are computed by the inverse kinematics on a grid, so that their limits hold
/// along it, and so that an infeasible path is refused before it begins.
class ToolPath : public RobotPath {
 public:
  /// Properties of a path other than its shape.
  struct Plan {
    std::unique_ptr<PosePath> path;
    std::vector<double> stops;      ///< as of RobotPath
    std::vector<double> waypoints;  ///< as of RobotPath
    bool timed = false;             ///< as of RobotPath
    PathLimits limits;              ///< of the tool; ignored when timed
  };

  /// `near`: the joints at the path's start. Throws NonFatalError: out_of_workspace, singular, joint_limit,
  /// motor_limit, with the place on the path.
  ToolPath(const Robot& robot, const JointVector& near, Plan plan);
  /// For a path without an intermediate stop or waypoint.
  static std::unique_ptr<ToolPath> whole(const Robot& robot, const JointVector& near, std::unique_ptr<PosePath> path,
                                         const PathLimits& limits);

  static constexpr double kShortest = 1e-9;  ///< s at full speed; a shorter path has no length

  PathRates rates(std::size_t piece, double s) const noexcept override;
  JointVector joints(double s) const noexcept override;
  void command(double s, double speed, double acceleration, RobotCommand& command) const noexcept override;

 private:
  /// The data of one piece at equal distances.
  struct Table {
    std::vector<JointVector> joints;
    std::vector<PathRates> rates;
  };
  JointVector joints_on_path(const Robot& robot, const Pose& pose, const JointVector& near, double s) const;
  void fill(const Robot& robot, std::size_t piece, JointVector& near);
  /// The joints' derivatives where the grid is so fine that differences along it are rounding errors: differences along
  /// the tool's Taylor polynomial there, of more than a piece's length.
  void differentiate(const JointVector& joints, const PathPose& tool, PathRates& rates) const;
  double spacing(std::size_t piece) const noexcept;

  std::unique_ptr<PosePath> path_;
  ToolKinematics kinematics_;
  std::size_t intervals_ = 0;  ///< of a piece
  std::vector<Table> tables_;
};

}  // namespace mrroc
