#include "cli/ros2/trajectory_goal.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "cli/ros2/private_file.hpp"
#include "config/entries/trajectory_entry.hpp"
#include "mrroc/testing/scratch_folder.hpp"

namespace mrroc::cli::trajectory_goal_test {
namespace {

using Goal = messages::control_msgs::FollowJointTrajectoryGoal;
using messages::builtin_interfaces::Duration;
using messages::builtin_interfaces::Time;

const std::vector<std::string> kJoints{"column", "lower", "wrist"};

Duration duration(std::int32_t sec, std::uint32_t nanosec = 0) {
  Duration duration;
  duration.sec = sec;
  duration.nanosec = nanosec;
  return duration;
}

Time at(std::int32_t sec) {
  Time time;
  time.sec = sec;
  return time;
}

/// Points at 1, 2 and 3 s, with the joints in another order than the axes.
Goal example() {
  Goal goal;
  goal.trajectory.joint_names = {"wrist", "column", "lower"};
  for (int i = 1; i <= 3; ++i) {
    messages::trajectory_msgs::JointTrajectoryPoint point;
    point.positions = {i + 0.3, i + 0.1, i + 0.2};
    point.velocities = {0.3, 0.1, 0.2};
    point.time_from_start = duration(i);
    goal.trajectory.points.push_back(point);
  }
  return goal;
}

/// Why the example with this change is refused.
std::string refusal_of(const std::function<void(Goal&)>& change) {
  Goal goal = example();
  change(goal);
  try {
    read_goal(goal, kJoints, at(100));
  } catch (const GoalRefused& refused) {
    return refused.what();
  }
  return "accepted";
}

TEST(TrajectoryGoal, JointsAreInTheOrderOfTheAxes) {
  const TrajectoryGoal goal = read_goal(example(), kJoints, at(100));
  ASSERT_EQ(goal.points.size(), 3u);
  EXPECT_EQ(goal.points[0].positions, (std::vector{1.1, 1.2, 1.3}));
  EXPECT_EQ(goal.points[0].velocities, (std::vector{0.1, 0.2, 0.3}));
  EXPECT_TRUE(goal.points[0].accelerations.empty());
  EXPECT_EQ(goal.points[2].time, 3);
  EXPECT_TRUE(goal.path_tolerance.empty());
}

TEST(TrajectoryGoal, TolerancesOfPositionsAreByJoint) {
  Goal goal = example();
  goal.path_tolerance = {{"wrist", 0.5, 9, 9}, {"column", -1, 0, 0}};
  goal.goal_tolerance = {{"lower", 0, 1, 1}};
  goal.goal_time_tolerance = duration(0, 250'000'000);
  const TrajectoryGoal own = read_goal(goal, kJoints, at(100));
  EXPECT_EQ(own.path_tolerance, (std::vector{0.0, 0.0, 0.5}));
  EXPECT_TRUE(own.goal_tolerance.empty());
  EXPECT_EQ(own.goal_time_tolerance, 0.25);
}

TEST(TrajectoryGoal, ATimeInTheHeaderMovesThePoints) {
  Goal goal = example();
  goal.trajectory.header.stamp = at(110);
  EXPECT_EQ(read_goal(goal, kJoints, at(100)).points[0].time, 11);
  goal.trajectory.header.stamp = at(98);
  const TrajectoryGoal late = read_goal(goal, kJoints, at(100));
  ASSERT_EQ(late.points.size(), 1u) << "points that are past are left out";
  EXPECT_EQ(late.points[0].time, 1);
  goal.trajectory.header.stamp = at(97);
  EXPECT_THROW(read_goal(goal, kJoints, at(100)), TrajectoryPast);
}

TEST(TrajectoryGoal, NamesWhatIsWrong) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal_of([](Goal& goal) { goal.trajectory.joint_names.pop_back(); }),
            "joint_names: without 'lower', expected all axes");
  EXPECT_EQ(refusal_of([](Goal& goal) { goal.trajectory.joint_names.push_back("x"); }),
            "joint_names: 'x', expected 'column', 'lower' or 'wrist'");
  EXPECT_EQ(refusal_of([](Goal& goal) { goal.trajectory.joint_names.push_back("wrist"); }),
            "joint_names: 4 names, expected 3, each once");
  EXPECT_EQ(refusal_of([](Goal& goal) { goal.trajectory.points.clear(); }), "0 points, expected 1 to 2000");
  EXPECT_EQ(refusal_of([](Goal& goal) { goal.trajectory.points.resize(2001); }), "2001 points, expected 1 to 2000");
  EXPECT_EQ(refusal_of([](Goal& goal) { goal.trajectory.points[1].positions.pop_back(); }),
            "points[1].positions: 2 values, expected 3");
  EXPECT_EQ(refusal_of([](Goal& goal) { goal.trajectory.points[1].velocities.clear(); }),
            "points[1].velocities: 0 values, expected 3");
  EXPECT_EQ(refusal_of([](Goal& goal) {
              goal.trajectory.points[2].accelerations = {1, 2, 3};
            }),
            "points[2].accelerations: 3 values, expected those of all points or of none");
  EXPECT_EQ(refusal_of([&](Goal& goal) { goal.trajectory.points[0].positions[1] = nan; }),
            "points[0].positions: nan, expected finite numbers");
  EXPECT_EQ(refusal_of([](Goal& goal) { goal.trajectory.points[1].time_from_start = duration(1); }),
            "points[1].time_from_start: 1 s, expected more than that of the point before");
  EXPECT_EQ(refusal_of([](Goal& goal) { goal.trajectory.points[0].time_from_start = duration(-1); }),
            "points[0].time_from_start: -1 s, expected at least 0 s");
  EXPECT_EQ(refusal_of([](Goal& goal) { goal.trajectory.points[0].time_from_start = duration(0, 1'000'000'000); }),
            "points[0].time_from_start: nanosec 1000000000, expected less than 1000000000");
  EXPECT_EQ(refusal_of([](Goal& goal) {
              goal.path_tolerance = {{"x", 1, 0, 0}};
            }),
            "path_tolerance: 'x', expected 'column', 'lower' or 'wrist'");
  EXPECT_EQ(refusal_of([&](Goal& goal) {
              goal.goal_tolerance = {{"wrist", nan, 0, 0}};
            }),
            "goal_tolerance of wrist: nan, expected a finite number");
  EXPECT_EQ(refusal_of([](Goal& goal) { goal.goal_time_tolerance = duration(-2); }),
            "goal_time_tolerance: -2 s, expected at least 0 s");
  EXPECT_EQ(refusal_of([](Goal& goal) { goal.multi_dof_trajectory.joint_names = {"base"}; }),
            "multi_dof_trajectory: not empty, expected none: the robot has no such joints");
}

TEST(TrajectoryGoal, TheFileHasTheSameNumbers) {
  Goal goal = example();
  goal.trajectory.points[0].positions[0] = 0.1 + 0.2;
  goal.trajectory.points.back().velocities.assign(kJoints.size(), 0);
  goal.path_tolerance = {{"wrist", 1.0 / 3, 0, 0}};
  goal.goal_time_tolerance = duration(2);
  const TrajectoryGoal own = read_goal(goal, kJoints, at(100));
  const task_test::ScratchFolder folder;
  std::filesystem::path path;
  {
    const PrivateFile file(folder.path(), trajectory_file(own));
    path = file.path();
    EXPECT_EQ(std::filesystem::status(path).permissions(),
              std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
    const auto read = config::load_trajectory(path, 3);
    ASSERT_EQ(read->points(), own.points.size());
    ASSERT_EQ(read->order(), JointTrajectory::Order::velocities);
    for (std::size_t point = 0; point < read->points(); ++point) {
      EXPECT_EQ(read->time(point), own.points[point].time);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(read->position(point, axis), own.points[point].positions[axis]);
        EXPECT_EQ(read->velocity(point, axis), own.points[point].velocities[axis]);
        EXPECT_EQ(read->path_tolerance(axis), own.path_tolerance[axis]);
      }
    }
    EXPECT_EQ(read->goal_time(), 2);
  }
  EXPECT_FALSE(std::filesystem::exists(path));
  EXPECT_THROW(PrivateFile(folder.path() / "missing", ""), std::runtime_error);
}

}  // namespace
}  // namespace mrroc::cli::trajectory_goal_test
