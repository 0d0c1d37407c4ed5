#include "mrroc/generators/joint_path.hpp"

#include <limits>

#include "language/paths/path_arm.hpp"
#include "mrroc/generators/joint_line.hpp"

namespace mrroc::joint_path_test {
namespace {

using fakes::check_property;
using fakes::PathArm;
using fakes::pick;

constexpr int kCases = 100;
constexpr double kRoom = 2;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

JointVector random_joints() {
  JointVector joints(6);
  // at a limit, too
  for (int i = 0; i < 6; ++i) joints[i] = std::clamp(0.01 * pick(-220, 220), -kRoom, kRoom);
  return joints;
}

std::vector<JointVector> random_waypoints() {
  std::vector<JointVector> waypoints;
  for (int i = pick(1, 6); i > 0; --i) waypoints.push_back(random_joints());
  return waypoints;
}

double random_speed() { return 0.01 * pick(20, 100); }

/// Limits +-2, speed 1, acceleration 10, jerk 100 of every axis; at rest in the middle.
struct Cell : PathArm {
  explicit Cell(std::uint16_t motion_steps = 1) : PathArm(Pose::Identity(), motion_steps, kRoom, 1) {}
};

/// Least distance of the motion from a waypoint, per joint.
double nearest(const Cell& cell, const JointVector& waypoint) {
  double least = 1e9;
  for (const JointVector& joints : cell.joints) least = std::min(least, (joints - waypoint).cwiseAbs().maxCoeff());
  return least;
}

void assert_within_limits(const Cell& cell, double speed, std::size_t first = 0) {
  const double dt = cell.dt();
  for (std::size_t k = first; k < cell.commands.size(); ++k) {
    const RobotCommand& now = cell.commands[k];
    RC_ASSERT(now.kind == CommandKind::joint);
    RC_ASSERT(now.joints.cwiseAbs().maxCoeff() <= kRoom + 1e-11);
    if (now.joint_velocity.size() == 0) continue;  // at rest
    RC_ASSERT(now.joint_velocity.cwiseAbs().maxCoeff() <= 0.99 * speed * (1 + 1e-6));
    RC_ASSERT(now.joint_acceleration.cwiseAbs().maxCoeff() <= 9 * speed * speed * (1 + 1e-6));
    if (k == first || cell.commands[k - 1].joint_velocity.size() == 0) continue;
    const RobotCommand& before = cell.commands[k - 1];
    const JointVector jerk = (now.joint_acceleration - before.joint_acceleration) / dt;
    RC_ASSERT(jerk.cwiseAbs().maxCoeff() <= 45 * speed * speed * speed * 1.001);
    // the trapezoidal rule, to third order: velocity and acceleration are the derivatives, and continuous
    const JointVector way = (now.joints - before.joints) / dt,
                      change = (now.joint_velocity - before.joint_velocity) / dt;
    RC_ASSERT((way - 0.5 * (now.joint_velocity + before.joint_velocity)).norm() < 50 * dt * dt);
    RC_ASSERT((change - 0.5 * (now.joint_acceleration + before.joint_acceleration)).norm() < 50 * dt);
  }
}

TEST(JointPath, PassesEveryWaypointWithinTheRobotsLimits) {
  check_property(kCases, [] {
    Cell cell;
    const std::vector<JointVector> waypoints = random_waypoints();
    const double speed = random_speed();
    cell.move(JointPath(*cell.arm, waypoints, speed));
    RC_ASSERT(cell.ending == Ending::generator);
    assert_within_limits(cell, speed);
    for (const JointVector& waypoint : waypoints) RC_ASSERT(nearest(cell, waypoint) <= 0.5 * cell.dt() * speed + 1e-9);
    RC_ASSERT(cell.commands.back().joints == waypoints.back());
    RC_ASSERT(cell.commands.back().joint_velocity.size() == 0);
  });
}

TEST(JointPath, DoesNotStopBetweenWaypoints) {
  check_property(kCases, [] {
    Cell cell;
    const std::vector<JointVector> waypoints = random_waypoints();
    double stopping = 0;
    {
      Cell other;
      for (const JointVector& waypoint : waypoints) {
        JointLine line(*other.arm, waypoint, 1);
        other.move(line);
        stopping += line.duration();
      }
    }
    JointPath path(*cell.arm, waypoints, 1);
    cell.move(path);
    // two lines of each cost their ramps; the spline is longer than the lines
    RC_ASSERT(path.duration() < 1.5 * stopping + 0.5);
    for (std::size_t k = 0; k + 1 < cell.commands.size(); ++k) RC_ASSERT(cell.commands[k].joint_velocity.size() == 6);
  });
}

TEST(JointPath, IsFasterThanLinesWithStops) {
  Cell cell, other;
  std::vector<JointVector> waypoints;
  double stopping = 0;
  for (int i = 1; i <= 8; ++i) {
    waypoints.push_back(JointVector::Constant(6, 0.2 * i));
    waypoints.back()[1] = 0.3 * std::sin(i);
    JointLine line(*other.arm, waypoints.back(), 1);
    other.move(line);
    stopping += line.duration();
  }
  JointPath path(*cell.arm, waypoints, 1);
  cell.move(path);
  EXPECT_LT(path.duration(), 0.6 * stopping);
}

TEST(JointPath, StraightLineTakesNearlyTheMinimumTime) {
  check_property(kCases, [] {
    Cell cell, other;
    const JointVector target = random_joints();
    const double speed = random_speed();
    JointLine line(*other.arm, target, speed);
    other.move(line);
    JointPath path(*cell.arm, {target}, speed);
    cell.move(path);
    RC_ASSERT(path.duration() >= line.duration() - 1e-6);
    RC_ASSERT(path.duration() <= 1.3 * line.duration() + cell.dt());
  });
}

TEST(JointPath, SpeedOnlyStretchesTime) {
  Cell fast, slow;
  const std::vector<JointVector> waypoints{JointVector::Constant(6, 0.5), JointVector::LinSpaced(6, -1, 1)};
  JointPath one(*fast.arm, waypoints, 1), half(*slow.arm, waypoints, 0.5);
  fast.move(one);
  slow.move(half);
  EXPECT_NEAR(half.duration(), 2 * one.duration(), 0.05 * half.duration());
}

// between two waypoints at a limit the plain spline would exceed it
TEST(JointPath, DoesNotExceedAPositionLimit) {
  Cell cell;
  JointVector low = JointVector::Zero(6), high = low, other = low;
  low[0] = kRoom - 1.5;
  high[0] = other[0] = kRoom;
  high[1] = 1;
  other[1] = 0.5;
  cell.move(JointPath(*cell.arm, {low, high, other, low}, 1));
  double most = 0;
  for (const JointVector& joints : cell.joints) most = std::max(most, joints[0]);
  EXPECT_LE(most, kRoom + 1e-11);
  EXPECT_LT(nearest(cell, high), 0.5 * cell.dt() + 1e-9);
}

TEST(JointPath, PassesTheRemainingWaypointsAfterAnInterruption) {
  check_property(kCases, [] {
    Cell cell;
    const std::vector<JointVector> waypoints = random_waypoints();
    const bool paused = cell.interrupt_at(pick(1, 1500)) == PathArm::Interruption::pause;
    cell.move(JointPath(*cell.arm, waypoints, 0.7));
    RC_ASSERT(cell.ending == Ending::generator);
    RC_ASSERT(cell.commands.back().joints == waypoints.back());
    for (const JointVector& waypoint : waypoints) RC_ASSERT(nearest(cell, waypoint) <= 0.5 * cell.dt() + 1e-6);
    if (cell.resumed_at == 0 || cell.resumed_at == cell.commands.size()) return;
    const JointVector first = cell.joints[cell.resumed_at] - cell.rested_at;
    RC_ASSERT(first.cwiseAbs().maxCoeff() <= 10 * cell.dt() * cell.dt());
    if (paused) {
      assert_within_limits(cell, 0.7);
    } else {
      assert_within_limits(cell, 1, cell.resumed_at);
    }
  });
}

TEST(JointPath, ComesToRestFirstFromAPresentMotion) {
  check_property(kCases, [] {
    Cell cell;
    JointVector velocity(6);
    for (int i = 0; i < 6; ++i) velocity[i] = 0.01 * pick(-90, 90);
    cell.roll(velocity);
    const std::vector<JointVector> waypoints = random_waypoints();
    cell.move(JointPath(*cell.arm, waypoints));
    RC_ASSERT(cell.commands.back().joints == waypoints.back());
    JointVector before = velocity;
    for (const RobotCommand& command : cell.commands) {
      const JointVector now =
          command.joint_velocity.size() == 0 ? JointVector(JointVector::Zero(6)) : command.joint_velocity;
      RC_ASSERT((now - before).cwiseAbs().maxCoeff() <= 10 * cell.dt() + 1e-9);
      before = now;
    }
  });
}

TEST(JointPath, ReachesPosesThroughTheInverseKinematics) {
  Cell cell;
  Pose a(Eigen::Translation3d(0.3, -0.2, 0.5)), b = a;
  b.linear() = exp_rotation({0, 0, 0.7});
  cell.move(JointPath(*cell.arm, std::vector<Pose>{a, b}));
  EXPECT_TRUE(
      cell.commands.back().joints.isApprox((Eigen::VectorXd(6) << 0.3, -0.2, 0.5, 0, 0, 0.7).finished(), 1e-12));
  const Pose far(Eigen::Translation3d(kRoom + 0.1, 0, 0));
  EXPECT_THROW(cell.move(JointPath(*cell.arm, std::vector<Pose>{far})), NonFatalError);
}

TEST(JointPath, RefusesInvalidArguments) {
  Cell cell;
  const auto make = [&](const std::vector<JointVector>& waypoints, double speed) {
    JointPath{*cell.arm, waypoints, speed};
  };
  const JointVector good = JointVector::Zero(6);
  EXPECT_NO_THROW(make({good}, 1));
  EXPECT_THROW(make({}, 1), NonFatalError);
  EXPECT_THROW(make({good, JointVector::Zero(5)}, 1), NonFatalError);
  EXPECT_THROW(make({JointVector::Constant(6, kNan)}, 1), NonFatalError);
  EXPECT_THROW(make({JointVector::Constant(6, kRoom + 0.01)}, 1), NonFatalError);
  for (const double speed : {0.0, -0.1, 1.001, kNan}) EXPECT_THROW(make({good}, speed), NonFatalError) << speed;
  EXPECT_THROW((JointPath{*cell.arm, std::vector<Pose>{}}), NonFatalError);
}

}  // namespace
}  // namespace mrroc::joint_path_test
