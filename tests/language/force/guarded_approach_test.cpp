#include "mrroc/generators/guarded_approach.hpp"

#include <limits>
#include <set>

#include "geometry/rigid_motion.hpp"
#include "language/fakes.hpp"
#include "language/motion_recorder.hpp"
#include "language/property.hpp"
#include "language/random_values.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/move.hpp"

namespace mrroc::guarded_approach_test {
namespace {

using Eigen::Vector3d;
using fakes::check_property;
using fakes::FakeTask;
using fakes::MotionRecorder;
using fakes::pick;

constexpr int kCases = 300;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

struct Place {
  JointVector joints = Eigen::Vector4d(0.1, -0.2, 0.3, 0.7);
  std::uint16_t motion_steps = 10, reply_step = 8;
  Vector3d direction{1, -2, 3};
};

Place random_place() {
  Place place;
  place.joints = Eigen::Vector4d(0.1 * pick(-5, 5), 0.1 * pick(-5, 5), 0.1 * pick(-5, 5), 0.01 * pick(-300, 300));
  place.motion_steps = static_cast<std::uint16_t>(pick(0, 5) == 0 ? pick(20, 100) : pick(1, 20));
  place.reply_step = static_cast<std::uint16_t>(pick(1, place.motion_steps));
  place.direction = Vector3d(pick(-10, 10), pick(-10, 10), pick(1, 10));
  return place;
}

/// A gantry before a wall, whose distance is measured along a direction of the tool.
struct Cell {
  explicit Cell(double distance, const Place& place = Place{})
      : arm(task.robot("arm", 4)), direction(place.direction), at_start(distance) {
    RobotState& state = task.robot_fake("arm").state;
    state.desired_joints = place.joints;
    state.desired_pose = state.pose = start = arm->kinematics().direct(state.desired_joints);
    arm->set_macrostep(place.motion_steps, place.reply_step);
    task.step_observer = &recorder;
  }
  /// Distance of the pose from the wall at rest, along the direction.
  double distance(const Pose& pose) const {
    return at_start - (pose.translation() - start.translation()).dot(start.linear() * direction.normalized());
  }
  GuardedApproach approach(double speed, double stop_distance, double acceleration, int patience = 50) {
    return {*arm,
            [this]() -> std::optional<double> {
              if (lost.contains(reading++)) return lost_as;
              return distance(arm->state().pose);
            },
            direction,
            speed,
            stop_distance,
            acceleration,
            patience};
  }
  /// Speed along the direction at the end of each command; checks that there is no other motion.
  std::vector<double> speeds() const {
    std::vector<double> result;
    const Vector3d way = start.linear() * direction.normalized();
    for (const RobotCommand& command : recorder.commands) {
      result.push_back(command.twist.head<3>().dot(way));
      EXPECT_LT((command.twist.head<3>() - result.back() * way).norm(), 1e-9);
      EXPECT_LT(command.twist.tail<3>().norm(), 1e-12);
    }
    return result;
  }

  FakeTask task;
  std::unique_ptr<Robot> arm;
  Pose start;
  Vector3d direction;
  double at_start;
  std::set<int> lost;  ///< numbers of the lost readings
  std::optional<double> lost_as;
  int reading = 0;
  MotionRecorder recorder;
};

TEST(GuardedApproach, StopsAtTheDistanceAndNeverNearer) {
  check_property(kCases, [] {
    Cell cell(0.01 * pick(1, 50), random_place());
    const double speed = 0.01 * pick(5, 50), stop = cell.at_start * 0.1 * pick(-3, 10),
                 acceleration = 0.01 * pick(1, 200);
    const Outcome end = Move({*cell.arm}, {}, cell.approach(speed, stop, acceleration).until(ElapsedSteps{20000}));
    RC_ASSERT(end.ending == Ending::generator);
    const Pose reached = cell.arm->state().desired_pose;
    RC_ASSERT(cell.distance(reached) >= std::min(stop, cell.at_start) - 1e-9);
    RC_ASSERT(cell.distance(reached) <= stop + GuardedApproach::kTolerance + 1e-9);
    double before = 0;
    for (const double now : cell.speeds()) {
      RC_ASSERT(now <= speed + 1e-9 && now >= -1e-9);
      RC_ASSERT(std::abs(now - before) <= acceleration * cell.arm->step_duration() + 1e-9);
      before = now;
    }
    RC_ASSERT(before == 0.0);
  });
}

// at every step it must be able to stop before the distance with its acceleration
TEST(GuardedApproach, CanStopBeforeTheDistanceAtEveryStep) {
  check_property(kCases, [] {
    Cell cell(0.01 * pick(10, 50), random_place());
    const double speed = 0.01 * pick(5, 50), acceleration = 0.01 * pick(5, 200), stop = 0.05;
    Move({*cell.arm}, {}, cell.approach(speed, stop, acceleration).until(ElapsedSteps{20000}));
    const std::vector<double> speeds = cell.speeds();
    for (std::size_t i = 0; i < speeds.size(); ++i) {
      const double remaining = cell.distance(cell.recorder.commands[i].pose) - stop;
      RC_ASSERT(speeds[i] * speeds[i] / (2 * acceleration) <= std::max(remaining, 0.0) + 1e-9);
    }
  });
}

TEST(GuardedApproach, ReachesThePermittedSpeed) {
  Cell cell(1.0);
  const Outcome end = Move({*cell.arm}, {}, cell.approach(0.1, 0.1, 0.4).until(ElapsedSteps{20000}));
  const std::vector<double> speeds = cell.speeds();
  EXPECT_NEAR(*std::max_element(speeds.begin(), speeds.end()), 0.1, 1e-9);
  EXPECT_LT(end.duration, 9.0 + 2.5) << "0.9 m at 0.1 m/s, and the time to start and to stop";
}

TEST(GuardedApproach, LostReadingsStopItAndItContinuesAfterwards) {
  check_property(kCases, [] {
    Cell cell(1.0, random_place());
    const double acceleration = 0.01 * pick(10, 200);
    const int from = pick(1, 100), length = pick(1, 60);
    for (int i = 0; i < length; ++i) cell.lost.insert(from + i);
    if (pick(0, 1) == 1) cell.lost_as = kNan;
    const Outcome end = Move({*cell.arm}, {}, cell.approach(0.2, 0.1, acceleration, length).until(ElapsedSteps{20000}));
    RC_ASSERT(end.ending == Ending::generator);
    const std::vector<double> speeds = cell.speeds();
    // the jerk first removes the present acceleration, then builds up the opposite one
    const double ramp = 0.2, dt = cell.arm->step_duration();
    for (int i = 0; i < length && static_cast<std::size_t>(from + i) < speeds.size(); ++i) {
      const double since = (i + 1) * dt - ramp;
      const double most = 0.2 - acceleration * std::max(since, 0.0);
      if (since > 0) RC_ASSERT(speeds[static_cast<std::size_t>(from + i)] <= std::max(most, 0.0) + 0.02 * acceleration);
    }
  });
}

TEST(GuardedApproach, ThrowsWhenNoMoreReadingsCome) {
  check_property(50, [] {
    Cell cell(1.0, random_place());
    const int from = pick(0, 50), patience = pick(0, 80);
    for (int i = 0; i <= patience; ++i) cell.lost.insert(from + i);
    try {
      Move({*cell.arm}, {}, cell.approach(0.2, 0.1, 0.5, patience).until(ElapsedSteps{20000}));
      RC_FAIL("no error");
    } catch (const NonFatalError& error) {
      RC_ASSERT(error.code() == ErrorCode::sensor_not_ready);
      RC_ASSERT(error.origin().device == "arm");
      RC_ASSERT(cell.recorder.commands.size() == static_cast<std::size_t>(from + patience));
    }
  });
}

TEST(GuardedApproach, CommandsNothingAtTheDistance) {
  Cell cell(0.05);
  EXPECT_EQ(Move({*cell.arm}, {}, cell.approach(0.1, 0.05, 0.2)).steps, 0u);
  EXPECT_EQ(Move({*cell.arm}, {}, cell.approach(0.1, 0.2, 0.2)).steps, 0u);
}

TEST(GuardedApproach, ApproachingObjectStopsItWithoutARetreat) {
  Cell cell(1.0);
  double wall = 0;
  GuardedApproach approach(
      *cell.arm, [&] { return cell.distance(cell.arm->state().pose) - (wall += 0.004); }, cell.direction, 0.1, 0.2,
      0.5);
  Move({*cell.arm}, {}, approach);
  for (const double speed : cell.speeds()) EXPECT_GE(speed, -1e-9);
  EXPECT_LT(cell.distance(cell.arm->state().pose) - wall, 0.2);
}

TEST(GuardedApproach, ErrorOfTheSensorIsThrownByTheMove) {
  Cell cell(1.0);
  const auto gate = cell.task.sensor("gate");
  cell.task.sensor_fake("gate").errors[5] = {ErrorClass::hardware, ErrorCode::sensor_hardware, {}};
  auto approach = cell.approach(0.1, 0.2, 0.5);
  EXPECT_THROW(Move({*cell.arm}, {*gate}, approach), HardwareError);
}

TEST(GuardedApproach, StartsFromRestAfterAPauseAndReachesTheDistance) {
  Cell cell(0.4);
  cell.task.requests.assign(20, OperatorRequest::none);
  cell.task.requests.push_back(OperatorRequest::pause);
  Move({*cell.arm}, {}, cell.approach(0.1, 0.2, 0.5));
  EXPECT_NEAR(cell.distance(cell.arm->state().desired_pose), 0.2, GuardedApproach::kTolerance + 1e-9);
}

TEST(GuardedApproach, RefusesInvalidArguments) {
  FakeTask task;
  const auto arm = task.robot("arm");
  const auto range = [] { return std::optional<double>(1.0); };
  const Vector3d z = Vector3d::UnitZ();
  EXPECT_THROW(GuardedApproach(*arm, range, Vector3d::Zero(), 0.1, 0.1), NonFatalError);
  EXPECT_THROW(GuardedApproach(*arm, range, Vector3d(0, kNan, 1), 0.1, 0.1), NonFatalError);
  for (const double speed : {0.0, -0.1, kNan}) EXPECT_THROW(GuardedApproach(*arm, range, z, speed, 0.1), NonFatalError);
  EXPECT_THROW(GuardedApproach(*arm, range, z, 0.1, kNan), NonFatalError);
  for (const double a : {0.0, -1.0, kNan}) EXPECT_THROW(GuardedApproach(*arm, range, z, 0.1, 0.1, a), NonFatalError);
  EXPECT_THROW(GuardedApproach(*arm, range, z, 0.1, 0.1, 0.2, -1), NonFatalError);
  EXPECT_THROW(GuardedApproach(*arm, nullptr, z, 0.1, 0.1), NonFatalError);
}

TEST(GuardedApproach, BrakesAPresentMotionWithTheJointsLimits) {
  check_property(kCases, [] {
    Cell cell(1, random_place());
    const Vector3d way = cell.start.linear() * cell.direction.normalized();
    RobotState& state = cell.task.robot_fake("arm").state;
    state.desired_velocity = JointVector::Zero(4);
    const double fast = 0.01 * pick(10, 40), slow = 0.001 * pick(5, 50), acceleration = 0.001 * pick(20, 100);
    state.desired_velocity.head<3>() = fast * way;
    GuardedApproach approach = cell.approach(slow, 0.02, acceleration);
    approach.until(ElapsedSteps{400});
    Move({*cell.arm}, {}, approach);
    // half of 0.9 of 4 m/s^2 shared by three axes, half of 0.45 of 40 m/s^3: far less than 1 / acceleration
    const double step = cell.arm->step_duration();
    const double braking = fast * (fast / 1.0 + 1.0 / 5 + 2 * step);
    for (std::size_t i = 0; i < cell.recorder.commands.size(); ++i) {
      const RobotCommand& command = cell.recorder.commands[i];
      if (cell.distance(command.pose) > 1 - braking) continue;
      RC_ASSERT(command.twist.head<3>().norm() <= slow + 1e-9);
    }
    RC_ASSERT(cell.distance(cell.recorder.commands.back().pose) > 0);
  });
}

}  // namespace
}  // namespace mrroc::guarded_approach_test
