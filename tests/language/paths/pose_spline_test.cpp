#include "mrroc/generators/pose_spline.hpp"

#include <limits>

#include "language/paths/path_arm.hpp"

namespace mrroc::pose_spline_test {
namespace {

using Eigen::Vector3d;
using fakes::check_property;
using fakes::PathArm;
using fakes::pick;
using fakes::random_pose;

constexpr int kCases = 60;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

const PathLimits kLimits{.speed = 0.4, .acceleration = 1, .angular_speed = 1, .angular_acceleration = 2};

std::vector<Pose> random_poses() {
  std::vector<Pose> poses;
  for (int i = pick(1, 6); i > 0; --i) poses.push_back(random_pose(0.3, 0.8));
  return poses;
}

SplineKind random_kind() { return static_cast<SplineKind>(pick(0, 2)); }

/// Least distance of the commanded poses from `first` on from a pose, m or rad.
double nearest(const PathArm& task, const Pose& pose, std::size_t first = 0) {
  double least = 1e9;
  for (std::size_t k = first; k < task.commands.size(); ++k) {
    const RobotCommand& command = task.commands[k];
    if (command.kind == CommandKind::pose)
      least = std::min(least, fakes::distance(command.pose, pose) + fakes::angle(command.pose, pose));
  }
  return least;
}

TEST(PoseSpline, PassesEveryPoseWithinItsLimitsBySpeed) {
  check_property(kCases, [] {
    const std::vector<Pose> poses = random_poses();
    PathArm task(random_pose(0.3, 0.8));
    const SplineKind kind = random_kind();
    task.move(PoseSpline(*task.arm, poses, kind, kLimits));
    RC_ASSERT(task.ending == Ending::generator);
    fakes::assert_tool_motion(task, kLimits);
    // the distance of half a tick
    for (const Pose& pose : poses)
      RC_ASSERT(nearest(task, pose) <= 0.5 * task.dt() * (kLimits.speed + kLimits.angular_speed) + 1e-9);
    RC_ASSERT(task.commands.back().pose.isApprox(poses.back(), 1e-14));
    std::size_t rests = 0;
    for (const RobotCommand& command : task.commands) rests += command.twist.isZero(0) ? 1 : 0;
    RC_ASSERT(rests == (kind == SplineKind::linear ? poses.size() : 1));
  });
}

TEST(PoseSpline, LinearIsStraightBetweenThePoses) {
  check_property(kCases, [] {
    const std::vector<Pose> poses = random_poses();
    const Pose start = random_pose(0.3, 0.8);
    PathArm task(start);
    task.move(PoseSpline(*task.arm, poses, SplineKind::linear, kLimits));
    Pose from = start;
    std::size_t leg = 0;
    for (const RobotCommand& command : task.commands) {
      const Vector3d way = poses[leg].translation() - from.translation();
      const Vector3d gone = command.pose.translation() - from.translation();
      RC_ASSERT(gone.cross(way.normalized()).norm() < 1e-9);
      if (!command.twist.isZero(0)) continue;
      RC_ASSERT(command.pose.isApprox(poses[leg], 1e-14));
      from = poses[leg++];
    }
    RC_ASSERT(leg == poses.size());
  });
}

/// Poses with times on ticks, slow enough for every limit.
std::vector<TimedPose> with_times(const std::vector<Pose>& poses, double dt) {
  std::vector<TimedPose> timed;
  double time = 0;
  for (const Pose& pose : poses) timed.push_back({pose, time += dt * pick(400, 2000)});
  return timed;
}

TEST(PoseSpline, IsInEveryPoseAtItsTickByTimes) {
  check_property(kCases, [] {
    PathArm task(random_pose(0.3, 0.8));
    const std::vector<TimedPose> timed = with_times(random_poses(), task.dt());
    PoseSpline spline(*task.arm, timed, random_kind());
    task.move(spline);
    RC_ASSERT(std::abs(spline.duration() - timed.back().time) < 1e-9);
    for (const TimedPose& point : timed) {
      const auto tick = static_cast<std::size_t>(std::lround(point.time / task.dt()));
      RC_ASSERT(fakes::distance(task.commands.at(tick - 1).pose, point.pose) < 1e-9);
      RC_ASSERT(fakes::angle(task.commands.at(tick - 1).pose, point.pose) < 1e-7);
    }
  });
}

// velocity and acceleration, linear and angular, from tick to tick across all the poses; the jerk bounds them
TEST(PoseSpline, VelocityAndAccelerationAreContinuousByTimes) {
  check_property(kCases, [] {
    PathArm task(random_pose(0.3, 0.8));
    task.move(PoseSpline(*task.arm, with_times(random_poses(), task.dt()), random_kind()));
    const double dt = task.dt();
    Twist twist = Twist::Zero(), rate = Twist::Zero();
    Pose before = task.commands.front().pose;
    for (const RobotCommand& command : task.commands) {
      const Twist change = command.twist - twist;
      RC_ASSERT((change / dt - 0.5 * (Twist(command.twist_acceleration) + rate)).norm() < 0.02);
      RC_ASSERT((Twist(command.twist_acceleration) - rate).norm() < 0.5);
      twist = command.twist;
      rate = command.twist_acceleration;
      before = command.pose;
    }
    RC_ASSERT(twist.isZero(0));
    RC_ASSERT(rate.isZero(0));
  });
}

/// Angle about one axis and its time derivatives, from the commands.
TEST(PoseSpline, QuinticAboutOneAxisHasContinuousJerkAndTheCommandedAngle) {
  std::vector<TimedPose> timed;
  for (int i = 1; i <= 8; ++i) {
    Pose pose = Pose::Identity();
    pose.linear() = exp_rotation(Vector3d(0, 0, 1.2 * i + (i % 2 == 0 ? 0.3 : 0)));
    timed.push_back({pose, 2.0 * i});
  }
  PathArm task(Pose::Identity());
  task.move(PoseSpline(*task.arm, timed, SplineKind::quintic));
  double turned = 0, worst = 0;
  Twist before = Twist::Zero(), jerk_before = Twist::Zero();
  for (std::size_t k = 0; k < task.commands.size(); ++k) {
    turned += task.dt() * task.commands[k].twist[5];
    const Twist jerk = (Twist(task.commands[k].twist_acceleration) - before) / task.dt();
    if (k > 1) worst = std::max(worst, (jerk - jerk_before).norm());
    before = task.commands[k].twist_acceleration;
    jerk_before = jerk;
  }
  EXPECT_NEAR(turned, 1.2 * 8 + 0.3, 1e-3);
  EXPECT_LT(worst, 0.1) << "of the angular jerk from tick to tick, rad/s^3";
}

TEST(PoseSpline, PassesTheRemainingPosesAfterAnInterruption) {
  check_property(kCases, [] {
    const std::vector<Pose> poses = random_poses();
    const bool timed = pick(0, 1) == 1;
    PathArm task(random_pose(0.3, 0.8));
    const SplineKind kind = random_kind();
    PoseSpline spline =
        timed ? PoseSpline(*task.arm, with_times(poses, task.dt()), kind) : PoseSpline(*task.arm, poses, kind, kLimits);
    const bool paused = task.interrupt_at(pick(1, 3000)) == PathArm::Interruption::pause;
    task.move(spline);
    RC_ASSERT(task.ending == Ending::generator);
    RC_ASSERT(task.commands.back().pose.isApprox(poses.back(), 1e-12));
    if (task.resumed_at == 0 || task.resumed_at == task.commands.size()) return;
    if (paused && !timed) fakes::assert_tool_motion(task, kLimits);
    for (const Pose& pose : poses) RC_ASSERT(nearest(task, pose) < 3e-3);
    const JointVector first = task.joints[task.resumed_at] - task.rested_at;
    RC_ASSERT(first.cwiseAbs().maxCoeff() <= 0.5 * 1e4 * task.dt() * task.dt());
  });
}

TEST(PoseSpline, RefusesTimesThatAreTooShortWithTheFactor) {
  PathArm task(Pose::Identity(), 10, 100, 0.5);
  Pose target(Eigen::Translation3d(1, 0, 0));
  target.linear() = exp_rotation({0, 0, 0.1});
  try {
    task.move(PoseSpline(*task.arm, std::vector<TimedPose>{{target, 2.0}}));
    FAIL();
  } catch (const NonFatalError& error) {
    // 10 u^3 - 15 u^4 + 6 u^5 has a peak velocity of 1.875 times the mean
    EXPECT_EQ(error.code(), ErrorCode::velocity_limit);
    EXPECT_NE(error.detail().find("axis0 would be too fast at 1.0"), std::string::npos) << error.detail();
    EXPECT_NE(error.detail().find("1.8939"), std::string::npos) << error.detail();
  }
  EXPECT_TRUE(task.commands.empty());
  EXPECT_NO_THROW(task.move(PoseSpline(*task.arm, std::vector<TimedPose>{{target, 3.8}})));
}

TEST(PoseSpline, RepeatedPoseHasNoEffect) {
  const Pose a(Eigen::Translation3d(0.1, 0, 0)), b(Eigen::Translation3d(0.1, 0.1, 0));
  PathArm once(Pose::Identity()), twice(Pose::Identity());
  once.move(PoseSpline(*once.arm, {a, b}));
  twice.move(PoseSpline(*twice.arm, {Pose::Identity(), a, a, b, b}));
  ASSERT_EQ(once.commands.size(), twice.commands.size());
  for (std::size_t k = 0; k < once.commands.size(); ++k)
    EXPECT_EQ(once.commands[k].pose.matrix(), twice.commands[k].pose.matrix());
}

TEST(PoseSpline, RefusesInvalidArguments) {
  PathArm task(Pose::Identity());
  Pose bad = Pose::Identity();
  bad.linear() *= 2;
  const Pose good = Pose::Identity();
  const auto by_speed = [&](const std::vector<Pose>& poses, const PathLimits& limits) {
    PoseSpline{*task.arm, poses, SplineKind::cubic, limits};
  };
  const auto by_times = [&](const std::vector<TimedPose>& poses) { PoseSpline{*task.arm, poses}; };
  EXPECT_NO_THROW(by_speed({good}, {}));
  EXPECT_THROW(by_speed({}, {}), NonFatalError);
  EXPECT_THROW(by_speed({bad}, {}), NonFatalError);
  EXPECT_THROW(by_speed({good}, {.speed = -1}), NonFatalError);
  EXPECT_NO_THROW(by_times({{good, 1}}));
  EXPECT_THROW(by_times({}), NonFatalError);
  EXPECT_THROW(by_times({{bad, 1}}), NonFatalError);
  EXPECT_THROW(by_times({{good, 0}}), NonFatalError);
  EXPECT_THROW(by_times({{good, 2}, {good, 2}}), NonFatalError);
  EXPECT_THROW(by_times({{good, kNan}}), NonFatalError);
}

}  // namespace
}  // namespace mrroc::pose_spline_test
