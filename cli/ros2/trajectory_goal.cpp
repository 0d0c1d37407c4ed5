#include "cli/ros2/trajectory_goal.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "config/entries/trajectory_entry.hpp"
#include "config/text/message_text.hpp"

namespace mrroc::cli {

namespace {

using messages::builtin_interfaces::Duration;
using messages::builtin_interfaces::Time;
using messages::control_msgs::JointTolerance;
using messages::trajectory_msgs::JointTrajectory;
using messages::trajectory_msgs::JointTrajectoryPoint;

constexpr std::uint32_t kNanosecondsInSecond = 1'000'000'000;  // ns

template <class Moment>
std::int64_t ns_of(const Moment& moment, const std::string& name) {
  if (moment.nanosec >= kNanosecondsInSecond)
    throw GoalRefused(name + ": nanosec " + std::to_string(moment.nanosec) + ", expected less than 1000000000");
  return std::int64_t{moment.sec} * kNanosecondsInSecond + moment.nanosec;
}

double seconds_of(std::int64_t ns) { return static_cast<double>(ns) / kNanosecondsInSecond; }

/// Of each axis: the index of its joint in the trajectory.
std::vector<std::size_t> order_of(const std::vector<std::string>& given, const std::vector<std::string>& joints) {
  std::vector<std::size_t> order;
  for (const std::string& joint : joints) {
    const auto found = std::find(given.begin(), given.end(), joint);
    if (found == given.end())
      throw GoalRefused("joint_names: without " + config::in_quotes(joint) + ", expected all axes");
    order.push_back(static_cast<std::size_t>(found - given.begin()));
  }
  if (given.size() == joints.size()) return order;
  for (const std::string& name : given) {
    if (std::find(joints.begin(), joints.end(), name) == joints.end())
      throw GoalRefused("joint_names: " + config::in_quotes(name) + ", expected " + config::alternatives(joints));
  }
  throw GoalRefused("joint_names: " + std::to_string(given.size()) + " names, expected " +
                    std::to_string(joints.size()) + ", each once");
}

/// The values in the order of the axes.
std::vector<double> ordered(const std::vector<double>& values, const std::vector<std::size_t>& order,
                            const std::string& name) {
  if (values.size() != order.size())
    throw GoalRefused(name + ": " + std::to_string(values.size()) + " values, expected " +
                      std::to_string(order.size()));
  std::vector<double> own;
  for (const std::size_t index : order) {
    if (!std::isfinite(values[index]))
      throw GoalRefused(name + ": " + config::number_text(values[index]) + ", expected finite numbers");
    own.push_back(values[index]);
  }
  return own;
}

/// Empty, as in the first point, or `ordered`.
std::vector<double> derivative(const std::vector<double>& values, const std::vector<double>& first,
                               const std::vector<std::size_t>& order, const std::string& name) {
  if (!first.empty()) return ordered(values, order, name);
  if (values.empty()) return {};
  throw GoalRefused(name + ": " + std::to_string(values.size()) + " values, expected those of all points or of none");
}

std::vector<TrajectoryGoal::Point> read_points(const JointTrajectory& trajectory,
                                               const std::vector<std::size_t>& order) {
  const std::vector<JointTrajectoryPoint>& given = trajectory.points;
  if (given.empty() || given.size() > mrroc::JointTrajectory::kMostPoints)
    throw GoalRefused(std::to_string(given.size()) + " points, expected 1 to " +
                      std::to_string(mrroc::JointTrajectory::kMostPoints));
  std::vector<TrajectoryGoal::Point> points;
  std::int64_t least = 0;
  for (const JointTrajectoryPoint& each : given) {
    const std::string name = "points[" + std::to_string(points.size()) + "]";
    const std::int64_t time = ns_of(each.time_from_start, name + ".time_from_start");
    if (time < least)
      throw GoalRefused(name + ".time_from_start: " + config::number_text(seconds_of(time)) + " s, expected " +
                        (points.empty() ? "at least 0 s" : "more than that of the point before"));
    least = time + 1;
    TrajectoryGoal::Point point{seconds_of(time), ordered(each.positions, order, name + ".positions"), {}, {}};
    point.velocities = derivative(each.velocities, given.front().velocities, order, name + ".velocities");
    point.accelerations = derivative(each.accelerations, given.front().accelerations, order, name + ".accelerations");
    points.push_back(std::move(point));
  }
  return points;
}

/// Moves the points to the time of the header, if it has one.
void place_in_time(std::vector<TrajectoryGoal::Point>& points, const Time& stamp, const Time& now) {
  if (stamp == Time{}) return;
  const double delay = seconds_of(ns_of(stamp, "header.stamp") - ns_of(now, "now"));
  if (points.back().time + delay <= 0)
    throw TrajectoryPast("the last point is " + config::number_text(-(points.back().time + delay)) +
                         " s in the past, expected a point in the future");
  std::erase_if(points, [&](const TrajectoryGoal::Point& point) { return point.time + delay <= 0 && delay < 0; });
  for (TrajectoryGoal::Point& point : points) point.time += delay;
}

std::vector<double> read_tolerances(const std::vector<JointTolerance>& given, const std::vector<std::string>& joints,
                                    const std::string& name) {
  std::vector<double> tolerances(joints.size(), 0.0);
  for (const JointTolerance& each : given) {
    const auto joint = std::find(joints.begin(), joints.end(), each.name);
    if (joint == joints.end())
      throw GoalRefused(name + ": " + config::in_quotes(each.name) + ", expected " + config::alternatives(joints));
    if (!std::isfinite(each.position))
      throw GoalRefused(name + " of " + each.name + ": " + config::number_text(each.position) +
                        ", expected a finite number");
    tolerances[static_cast<std::size_t>(joint - joints.begin())] = std::max(each.position, 0.0);
  }
  if (std::all_of(tolerances.begin(), tolerances.end(), [](double tolerance) { return tolerance == 0; })) return {};
  return tolerances;
}

double read_time_tolerance(const Duration& given) {
  const std::int64_t tolerance = ns_of(given, "goal_time_tolerance");
  if (tolerance < 0)
    throw GoalRefused("goal_time_tolerance: " + config::number_text(seconds_of(tolerance)) +
                      " s, expected at least 0 s");
  return seconds_of(tolerance);
}

}  // namespace

TrajectoryGoal read_goal(const messages::control_msgs::FollowJointTrajectoryGoal& goal,
                         const std::vector<std::string>& joints, const Time& now) {
  if (!goal.multi_dof_trajectory.joint_names.empty() || !goal.multi_dof_trajectory.points.empty() ||
      !goal.component_path_tolerance.empty() || !goal.component_goal_tolerance.empty())
    throw GoalRefused("multi_dof_trajectory: not empty, expected none: the robot has no such joints");
  TrajectoryGoal own;
  own.points = read_points(goal.trajectory, order_of(goal.trajectory.joint_names, joints));
  own.path_tolerance = read_tolerances(goal.path_tolerance, joints, "path_tolerance");
  own.goal_tolerance = read_tolerances(goal.goal_tolerance, joints, "goal_tolerance");
  own.goal_time_tolerance = read_time_tolerance(goal.goal_time_tolerance);
  place_in_time(own.points, goal.trajectory.header.stamp, now);
  return own;
}

std::string trajectory_file(const TrajectoryGoal& goal) {
  using Order = mrroc::JointTrajectory::Order;
  const TrajectoryGoal::Point& first = goal.points.front();
  const Order order = first.velocities.empty()      ? Order::positions
                      : first.accelerations.empty() ? Order::velocities
                                                    : Order::accelerations;
  mrroc::JointTrajectory trajectory(first.positions.size(), order, goal.points.size());
  for (std::size_t i = 0; i < goal.points.size(); ++i) {
    const TrajectoryGoal::Point& point = goal.points[i];
    std::vector<double> values = point.positions;
    values.insert(values.end(), point.velocities.begin(), point.velocities.end());
    values.insert(values.end(), point.accelerations.begin(), point.accelerations.end());
    trajectory.set_point(i, point.time, values);
  }
  trajectory.set_tolerances(goal.path_tolerance, goal.goal_tolerance, goal.goal_time_tolerance);
  return config::text_of(trajectory);
}

}  // namespace mrroc::cli
