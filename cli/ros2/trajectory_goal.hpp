#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "messages/control_msgs/follow_joint_trajectory_goal.hpp"

namespace mrroc::cli {

/// A trajectory for one robot: rad or m and s, in the order of its axes.
struct TrajectoryGoal {
  struct Point {
    double time = 0;  ///< since the goal was accepted
    std::vector<double> positions;
    std::vector<double> velocities, accelerations;  ///< empty in all points, or in none
  };

  std::vector<Point> points;
  std::vector<double> path_tolerance, goal_tolerance;  ///< of each axis, 0: none; empty: of no axis
  double goal_time_tolerance = 0;                      ///< 0: not given
};

/// A goal is invalid. `what()`: the value and what was expected.
class GoalRefused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};
/// The last point of a trajectory is in the past.
class TrajectoryPast : public GoalRefused {
 public:
  using GoalRefused::GoalRefused;
};

/// Of a goal that is accepted at `now`. Joints may be in any order. A time in the trajectory's header moves its points;
/// those that are past then are left out. Tolerances of positions alone are read. `joints`: of the robot's axes. Throws
/// GoalRefused, TrajectoryPast. Any thread.
TrajectoryGoal read_goal(const messages::control_msgs::FollowJointTrajectoryGoal& goal,
                         const std::vector<std::string>& joints, const messages::builtin_interfaces::Time& now);

/// The file of a trajectory, as config::load_trajectory reads it. Any thread.
std::string trajectory_file(const TrajectoryGoal& goal);

}  // namespace mrroc::cli
