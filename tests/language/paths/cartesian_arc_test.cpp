#include "mrroc/generators/cartesian_arc.hpp"

#include <kdl/path_circle.hpp>
#include <kdl/rotational_interpolation_sa.hpp>
#include <limits>

#include "language/paths/kdl_frames.hpp"
#include "language/paths/path_arm.hpp"

namespace mrroc::cartesian_arc_test {
namespace {

using Eigen::Vector3d;
using fakes::check_property;
using fakes::PathArm;
using fakes::pick;
using fakes::random_pose;
using fakes::random_vector;

constexpr int kCases = 60;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

const PathLimits kLimits{.speed = 0.4, .acceleration = 1, .angular_speed = 1, .angular_acceleration = 2};

/// A circle at a random pose, with two unit vectors in its plane.
struct Ring {
  Vector3d centre = random_vector(0.3);
  Eigen::Matrix3d axes = exp_rotation(random_vector(2));
  double radius = 0.01 * pick(2, 30);
  Vector3d at(double angle) const { return centre + radius * axes * Vector3d(std::cos(angle), std::sin(angle), 0); }
  Vector3d axis() const { return axes.col(2); }
};

TEST(CartesianArc, FollowsTheCircleThroughThreePointsLikeKdlsCircle) {
  check_property(kCases, [] {
    const Ring ring;
    const double angle = 0.01 * pick(30, 600), part = 0.01 * pick(20, 80);
    Pose start = random_pose(0, 1), target = random_pose(0, 1);
    start.translation() = ring.at(0);
    target.translation() = ring.at(angle);
    PathArm task(start);
    task.move(CartesianArc(*task.arm, ring.at(part * angle), target, kLimits));
    RC_ASSERT(task.ending == Ending::generator);
    KDL::Path_Circle circle(fakes::to_kdl(start), fakes::to_kdl(ring.centre), fakes::to_kdl(ring.at(1)),
                            fakes::to_kdl(Eigen::Matrix3d(target.linear())), angle,
                            new KDL::RotationalInterpolation_SingleAxis(), kLimits.speed / kLimits.angular_speed);
    double last = 0;
    for (const RobotCommand& command : task.commands) {
      const Vector3d arm = ring.axes.transpose() * (command.pose.translation() - ring.centre);
      double at = std::atan2(arm.y(), arm.x());
      if (at < last - 1e-6) at += 2 * std::numbers::pi;
      RC_ASSERT(at <= angle + 1e-6);
      last = at;
      const Pose expected = fakes::from_kdl(circle.Pos(at / angle * circle.PathLength()));
      RC_ASSERT(fakes::distance(command.pose, expected) < 1e-9);
      RC_ASSERT(fakes::angle(command.pose, expected) < 1e-7);
    }
    RC_ASSERT(std::abs(last - angle) < 1e-6);
    RC_ASSERT(task.commands.back().pose.isApprox(target, 1e-14));
  });
}

TEST(CartesianArc, KeepsItsLimits) {
  check_property(kCases, [] {
    const Ring ring;
    Pose start = random_pose(0, 1), target = random_pose(0, 1);
    start.translation() = ring.at(0);
    target.translation() = ring.at(0.01 * pick(100, 600));
    PathArm task(start);
    task.move(CartesianArc(*task.arm, ring.at(0.5), target, kLimits));
    fakes::assert_tool_motion(task, kLimits);
  });
}

TEST(CartesianArc, FullTurnReturnsAndTheToolTurnsWithItOrNot) {
  check_property(kCases, [] {
    const Ring ring;
    Pose start = random_pose(0, 1);
    start.translation() = ring.at(0);
    PathArm task(start);
    const bool turns = pick(0, 1) == 1;
    const double angle = (pick(0, 1) == 1 ? 1 : -1) * 2 * std::numbers::pi;
    // any point of the axis
    const Circle circle{
        .centre = ring.centre + 0.1 * ring.axis(), .axis = 3 * ring.axis(), .angle = angle, .tool_turns = turns};
    task.move(CartesianArc(*task.arm, circle, kLimits));
    RC_ASSERT(fakes::distance(task.commands.back().pose, start) < 1e-12);
    RC_ASSERT(fakes::angle(task.commands.back().pose, start) < 1e-7);
    fakes::assert_tool_motion(task, kLimits);
    double way = 0;
    Pose before = start;
    for (const RobotCommand& command : task.commands) {
      const Vector3d arm = command.pose.translation() - ring.centre;
      RC_ASSERT(std::abs(arm.norm() - ring.radius) < 1e-12);
      RC_ASSERT(std::abs(arm.dot(ring.axis())) < 1e-12);
      const Eigen::Matrix3d turned = command.pose.linear() * start.linear().transpose();
      if (turns) {
        RC_ASSERT((turned * (start.translation() - ring.centre) - arm).norm() < 1e-12);
      } else {
        RC_ASSERT(turned.isIdentity(1e-12));
      }
      way += fakes::distance(command.pose, before);
      before = command.pose;
    }
    RC_ASSERT(std::abs(way - 2 * std::numbers::pi * ring.radius) < 1e-3);
  });
}

TEST(CartesianArc, AxisThroughTheToolOnlyTurnsIt) {
  PathArm task(Pose::Identity());
  task.move(CartesianArc(*task.arm, Circle{.axis = {0, 0, 1}, .angle = 2, .tool_turns = true}, kLimits));
  EXPECT_LT(fakes::distance(task.commands.back().pose, Pose::Identity()), 1e-12);
  EXPECT_NEAR(fakes::angle(task.commands.back().pose, Pose::Identity()), 2, 1e-12);
  task.commands.clear();
  task.move(CartesianArc(*task.arm, Circle{.axis = {0, 0, 1}, .angle = 2}, kLimits));
  EXPECT_TRUE(task.commands.empty()) << "without rotation there is no motion";
}

TEST(CartesianArc, SpeedOnASmallCircleIsLimitedByItsAcceleration) {
  PathArm task(Pose::Identity());
  const PathLimits limits{.speed = 1, .acceleration = 0.5};
  task.move(CartesianArc(*task.arm, Circle{.centre = {0.1, 0, 0}}, limits));
  double fastest = 0;
  for (const RobotCommand& command : task.commands) fastest = std::max(fastest, command.twist.norm());
  EXPECT_LE(fastest, std::sqrt(0.85 * 0.5 * 0.1) + 1e-9);
  EXPECT_GT(fastest, 0.99 * std::sqrt(0.85 * 0.5 * 0.1));
}

// a whole circle begins where it ends: the nearest point is searched only near the interruption
TEST(CartesianArc, FollowsTheRestAfterAnInterruption) {
  check_property(kCases, [] {
    const Ring ring;
    Pose start = random_pose(0, 1);
    start.translation() = ring.at(0);
    PathArm task(start, static_cast<std::uint16_t>(pick(1, 10)));
    const bool paused = task.interrupt_at(pick(1, 40)) == PathArm::Interruption::pause;
    task.move(CartesianArc(*task.arm, Circle{.centre = ring.centre, .axis = ring.axis()}, kLimits));
    RC_ASSERT(fakes::distance(task.commands.back().pose, start) < 1e-12);
    if (task.resumed_at == 0 || task.resumed_at == task.commands.size()) return;
    if (paused) fakes::assert_tool_motion(task, kLimits);
    double way = 0;
    for (std::size_t k = 1; k < task.commands.size(); ++k) {
      if (task.commands[k].kind != CommandKind::pose || task.commands[k - 1].kind != CommandKind::pose) continue;
      RC_ASSERT(std::abs((task.commands[k].pose.translation() - ring.centre).norm() - ring.radius) < 1e-9);
      way += fakes::distance(task.commands[k].pose, task.commands[k - 1].pose);
    }
    // all of it, except for the distance rolled on: at most 50 ms at the present speed
    RC_ASSERT(way > 2 * std::numbers::pi * ring.radius - 0.05 * kLimits.speed - 2 * task.dt() * kLimits.speed -
                        0.01 * ring.radius);
  });
}

TEST(CartesianArc, RefusesInvalidArguments) {
  PathArm task(Pose::Identity());
  const Pose target(Eigen::Translation3d(0.1, 0, 0));
  const auto through = [&](const Vector3d& via) { task.move(CartesianArc(*task.arm, via, target)); };
  EXPECT_THROW(through({0.05, 0, 0}), NonFatalError);
  EXPECT_THROW(through({0.2, 0, 0}), NonFatalError);
  EXPECT_THROW(through({0, 0, 0}), NonFatalError);
  EXPECT_THROW(through({0.1, 0, 0}), NonFatalError);
  EXPECT_THROW(through({kNan, 0, 0}), NonFatalError);
  EXPECT_TRUE(task.commands.empty());
  EXPECT_NO_THROW(through({0.05, 0.01, 0}));
  const auto about = [&](const Circle& circle) { CartesianArc{*task.arm, circle}; };
  EXPECT_NO_THROW(about({}));
  EXPECT_THROW(about({.centre = {kNan, 0, 0}}), NonFatalError);
  EXPECT_THROW(about({.axis = {0, 0, 0}}), NonFatalError);
  EXPECT_THROW(about({.axis = {0, kNan, 0}}), NonFatalError);
  EXPECT_THROW(about({.angle = kNan}), NonFatalError);
}

}  // namespace
}  // namespace mrroc::cartesian_arc_test
