#include "mrroc/generators/blended_path.hpp"

#include <limits>

#include "language/paths/path_arm.hpp"

namespace mrroc::blended_path_test {
namespace {

using Eigen::Vector3d;
using fakes::check_property;
using fakes::PathArm;
using fakes::pick;
using fakes::random_pose;

constexpr int kCases = 60;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

const PathLimits kLimits{.speed = 0.4, .acceleration = 2, .angular_speed = 1, .angular_acceleration = 3};

std::vector<BlendPoint> random_points(double turn = 0.8) {
  std::vector<BlendPoint> points;
  for (int i = pick(1, 6); i > 0; --i) points.push_back({random_pose(0.3, turn), 0.01 * pick(0, 15)});
  return points;
}

/// Distance of a position from the line between two others.
double beside(const Vector3d& place, const Vector3d& from, const Vector3d& to) {
  const Vector3d way = to - from;
  const double u = std::clamp((place - from).dot(way) / way.squaredNorm(), 0.0, 1.0);
  return (place - from - u * way).norm();
}

// also the linear and the angular velocity: their rates are bounded, and are the derivatives
TEST(BlendedPath, KeepsItsLimitsAcrossTheBlendsAndEndsAtRest) {
  check_property(kCases, [] {
    const std::vector<BlendPoint> points = random_points();
    PathArm task(random_pose(0.3, 0.8));
    task.move(BlendedPath(*task.arm, points, kLimits));
    RC_ASSERT(task.ending == Ending::generator);
    fakes::assert_tool_motion(task, kLimits);
    RC_ASSERT(task.commands.back().pose.isApprox(points.back().pose, 1e-14));
    std::size_t stops = 1, rests = 0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) stops += points[i].radius == 0 ? 1 : 0;
    for (const RobotCommand& command : task.commands) rests += command.twist.isZero(0) ? 1 : 0;
    RC_ASSERT(rests == stops);
  });
}

TEST(BlendedPath, LeavesTheLinesOnlyWithinTheRadiusAndPassesTheCornerAtTheStatedDistance) {
  check_property(kCases, [] {
    const std::vector<BlendPoint> points = random_points(0.1);
    const Pose start = random_pose(0.3, 0.1);
    PathArm task(start);
    task.move(BlendedPath(*task.arm, points, kLimits));
    std::vector<Vector3d> corners{start.translation()};
    for (const BlendPoint& point : points) corners.push_back(point.pose.translation());
    std::vector<double> nearest(corners.size(), 1e9);
    for (const RobotCommand& command : task.commands) {
      const Vector3d p = command.pose.translation();
      double off = 1e9;
      bool blends = false;
      for (std::size_t i = 0; i + 1 < corners.size(); ++i) off = std::min(off, beside(p, corners[i], corners[i + 1]));
      for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        blends = blends || (p - corners[i]).norm() < points[i - 1].radius + 1e-9;
      RC_ASSERT(off < 1e-9 || blends);
      for (std::size_t i = 0; i < corners.size(); ++i) nearest[i] = std::min(nearest[i], (p - corners[i]).norm());
    }
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      const Vector3d in = (corners[i] - corners[i - 1]).normalized(), out = (corners[i + 1] - corners[i]).normalized();
      const double bound = 3.0 / 16 * points[i - 1].radius * (out - in).norm();
      RC_ASSERT(nearest[i] <= bound + task.dt() * kLimits.speed);
    }
  });
}

// a right-angled corner with the exact blend of the header
TEST(BlendedPath, BlendIsTheSmoothStepOfTheVelocity) {
  PathArm task(Pose::Identity());
  const double radius = 0.05;
  task.move(BlendedPath(*task.arm,
                        {{Pose(Eigen::Translation3d(0.2, 0, 0)), radius}, {Pose(Eigen::Translation3d(0.2, 0.2, 0))}},
                        kLimits));
  double least = 1e9;
  for (const RobotCommand& command : task.commands) {
    const Vector3d p = command.pose.translation() - Vector3d(0.2, 0, 0);
    least = std::min(least, p.norm());
    if (p.x() <= -radius || p.y() >= radius) continue;
    // find u by x, then y must be that of the blend
    double low = 0, high = 1;
    for (int k = 0; k < 60; ++k) {
      const double u = 0.5 * (low + high), w = 1 - u;
      (-radius * (2 * w * w * w - w * w * w * w) < p.x() ? low : high) = u;
    }
    EXPECT_NEAR(p.y(), radius * (2 * low * low * low - low * low * low * low), 1e-9);
  }
  EXPECT_NEAR(least, 3.0 / 16 * radius * std::sqrt(2), 1e-4);
}

TEST(BlendedPath, SpeedIsNearlyConstantWhereTheRadiusIsLargeEnough) {
  check_property(kCases, [] {
    // right-angled corners, with paths between the blends that are long enough for a constant speed
    const double radius = 0.01 * pick(3, 20);
    const PathLimits limits{.speed = std::sqrt(radius * 2 / 5), .acceleration = 2};
    std::vector<BlendPoint> points;
    Vector3d place = Vector3d::Zero();
    for (int i = 0; i < 4; ++i) {
      place[i % 2] += 0.8;
      points.push_back({Pose(Eigen::Translation3d(place)), radius});
    }
    PathArm task(Pose::Identity());
    task.move(BlendedPath(*task.arm, points, limits));
    // without the ramps at the start and the end
    for (const RobotCommand& command : task.commands) {
      const Vector3d p = command.pose.translation();
      if (p.norm() < 0.4 || (p - place).norm() < 0.4) continue;
      RC_ASSERT(command.twist.norm() > 0.93 * limits.speed);
    }
  });
}

TEST(BlendedPath, RotationsAndReversalsAreBlended) {
  Pose there(Eigen::Translation3d(0.2, 0, 0)), turned = there;
  turned.linear() = exp_rotation({0, 0, 1});
  Pose back = turned;
  back.translation() = Vector3d(0.05, 0, 0);
  Pose on = back;
  on.translation() = Vector3d(0.25, 0, 0);
  PathArm task(Pose::Identity());
  task.move(BlendedPath(*task.arm, {{there, 0.05}, {turned, 0.05}, {back, 0.05}, {on, 0}}, kLimits));
  EXPECT_EQ(task.ending, Ending::generator);
  check_property(1, [&] { fakes::assert_tool_motion(task, kLimits); });
  EXPECT_TRUE(task.commands.back().pose.isApprox(on, 1e-14));
  std::size_t rests = 0;
  double least = 1e9;
  for (std::size_t k = task.commands.size() / 2; k < task.commands.size(); ++k) {
    rests += task.commands[k].twist.isZero(0) ? 1 : 0;
    least = std::min(least, task.commands[k].pose.translation().x());
  }
  EXPECT_EQ(rests, 1u);
  EXPECT_NEAR(least, 0.05 + 3.0 / 8 * 0.05, 1e-4) << "it reverses before the corner";
}

TEST(BlendedPath, FollowsTheRestAfterAnInterruption) {
  check_property(kCases, [] {
    const std::vector<BlendPoint> points = random_points();
    PathArm whole(random_pose(0.3, 0.8));
    PathArm task(whole.state.desired_pose, static_cast<std::uint16_t>(pick(1, 10)));
    whole.move(BlendedPath(*whole.arm, points, kLimits));
    const bool paused = task.interrupt_at(pick(1, 200)) == PathArm::Interruption::pause;
    task.move(BlendedPath(*task.arm, points, kLimits));
    RC_ASSERT(task.ending == Ending::generator);
    RC_ASSERT(task.commands.back().pose.isApprox(points.back().pose, 1e-12));
    if (task.resumed_at == 0 || task.resumed_at == task.commands.size()) return;
    const JointVector first = task.joints[task.resumed_at] - task.rested_at;
    RC_ASSERT(first.cwiseAbs().maxCoeff() <= 0.5 * 1e4 * task.dt() * task.dt());
    if (paused) fakes::assert_tool_motion(task, kLimits);
    // every position of the interrupted motion is one of the whole motion; every tenth is checked
    for (std::size_t k = 0; k < task.commands.size(); k += 10) {
      if (task.commands[k].kind != CommandKind::pose) continue;
      double off = 1e9;
      for (const RobotCommand& command : whole.commands)
        off = std::min(off, fakes::distance(command.pose, task.commands[k].pose));
      RC_ASSERT(off <= 0.5 * whole.dt() * kLimits.speed + 1e-6);
    }
  });
}

TEST(BlendedPath, RefusesInvalidArguments) {
  PathArm task(Pose::Identity());
  Pose bad = Pose::Identity();
  bad.linear() *= 2;
  const auto make = [&](const std::vector<BlendPoint>& points, const PathLimits& limits) {
    BlendedPath{*task.arm, points, limits};
  };
  EXPECT_NO_THROW(make({{}}, {}));
  EXPECT_THROW(make({}, {}), NonFatalError);
  EXPECT_THROW(make({{bad, 0}}, {}), NonFatalError);
  EXPECT_THROW(make({{Pose::Identity(), -0.1}}, {}), NonFatalError);
  EXPECT_THROW(make({{Pose::Identity(), kNan}}, {}), NonFatalError);
  EXPECT_THROW(make({{}}, {.acceleration = 0}), NonFatalError);
}

}  // namespace
}  // namespace mrroc::blended_path_test
