#include "mrroc/generators/cartesian_line.hpp"

#include <kdl/path_line.hpp>
#include <kdl/rotational_interpolation_sa.hpp>
#include <limits>

#include "language/paths/kdl_frames.hpp"
#include "language/paths/path_arm.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/move.hpp"

namespace mrroc::cartesian_line_test {
namespace {

using Eigen::Vector3d;
using fakes::check_property;
using fakes::PathArm;
using fakes::pick;
using fakes::random_pose;

constexpr int kCases = 100;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

PathLimits random_limits() {
  return {.speed = 0.01 * pick(2, 50),
          .acceleration = 0.1 * pick(2, 20),
          .angular_speed = 0.05 * pick(2, 20),
          .angular_acceleration = 0.1 * pick(5, 40)};
}

TEST(CartesianLine, MovesStraightAndTurnsAboutOneAxisLikeKdlsLine) {
  check_property(kCases, [] {
    const Pose start = random_pose(0.5, 1), target = random_pose(0.5, 1);
    PathArm task(start);
    const PathLimits limits = random_limits();
    task.move(CartesianLine(*task.arm, target, limits));
    if (task.commands.empty()) return;
    KDL::Path_Line line(fakes::to_kdl(start), fakes::to_kdl(target), new KDL::RotationalInterpolation_SingleAxis(),
                        limits.speed / limits.angular_speed);
    const Vector3d way = target.translation() - start.translation();
    const Vector3d turn = rotation_vector(target.linear() * start.linear().transpose());
    double last = 0;
    for (const RobotCommand& command : task.commands) {
      // the travelled part, of the larger of translation and rotation
      const double u = way.norm() > 0.1
                           ? (command.pose.translation() - start.translation()).dot(way) / way.squaredNorm()
                           : rotation_vector(command.pose.linear() * start.linear().transpose()).norm() /
                                 std::max(turn.norm(), 1e-9);
      if (way.norm() < 0.1 && turn.norm() < 0.1) return;
      RC_ASSERT(u >= last - 1e-9);
      RC_ASSERT(u <= 1 + 1e-9);
      last = u;
      const Pose expected = fakes::from_kdl(line.Pos(u * line.PathLength()));
      RC_ASSERT(fakes::distance(command.pose, expected) < 1e-9);
      RC_ASSERT(fakes::angle(command.pose, expected) < 1e-7);
    }
  });
}

TEST(CartesianLine, KeepsItsLimitsAndEndsAtRest) {
  check_property(kCases, [] {
    const Pose target = random_pose(0.5, 1);
    PathArm task(random_pose(0.5, 1));
    const PathLimits limits = random_limits();
    task.move(CartesianLine(*task.arm, target, limits));
    RC_ASSERT(task.ending == Ending::generator);
    if (task.commands.empty()) return;
    fakes::assert_tool_motion(task, limits);
    RC_ASSERT(task.commands.back().pose.isApprox(target, 1e-14));
  });
}

/// The minimum time from rest to rest over a path with these limits: ramps of jerk, acceleration, speed.
double least_time(double way, double speed, double acceleration, double jerk) {
  // without constant speed: the peak p with p (p / a + a / j) = way, or p = (way^2 j / 4)^(1/3) also without constant
  // acceleration
  double peak = std::cbrt(0.25 * way * way * jerk);
  if (peak > acceleration * acceleration / jerk) {
    const double a = acceleration / jerk;
    peak = 0.5 * acceleration * (std::sqrt(a * a + 4 * way / acceleration) - a);
  }
  if (peak < speed)
    return peak > acceleration * acceleration / jerk ? 2 * (peak / acceleration + acceleration / jerk)
                                                     : 4 * std::sqrt(peak / jerk);
  const double ramp = speed > acceleration * acceleration / jerk ? speed / acceleration + acceleration / jerk
                                                                 : 2 * std::sqrt(speed / jerk);
  return way / speed + ramp;
}

TEST(CartesianLine, TakesNearlyTheMinimumTime) {
  check_property(kCases, [] {
    const PathLimits limits = random_limits();
    PathArm task(Pose::Identity());
    Pose target = Pose::Identity();
    const double way = 0.001 * pick(1, 1000);
    target.translation().x() = way;
    CartesianLine line(*task.arm, target, limits);
    task.move(line);
    const double least = least_time(way, limits.speed, limits.acceleration, 10 * limits.acceleration);
    RC_ASSERT(line.duration() >= least * (1 - 1e-6));
    RC_ASSERT(line.duration() <= 1.3 * least);
    RC_ASSERT(std::abs(line.duration() - static_cast<double>(task.commands.size()) * task.dt()) < 1e-9);
  });
}

TEST(CartesianLine, HoldsItsSpeedBetweenTheRamps) {
  PathArm task(Pose::Identity());
  Pose target = Pose::Identity();
  target.translation().x() = 1;
  task.move(CartesianLine(*task.arm, target, {.speed = 0.25, .acceleration = 1}));
  std::size_t constant = 0;
  for (const RobotCommand& command : task.commands) constant += std::abs(command.twist.norm() - 0.25) < 1e-9 ? 1 : 0;
  // 4 s plus the ramps: 0.25 s to accelerate, 0.2 s to smooth, twice
  EXPECT_GT(static_cast<double>(constant) * task.dt(), 4 - 0.9);
}

TEST(CartesianLine, JointLimitsHoldToo) {
  check_property(kCases, [] {
    const double fast = 0.01 * pick(5, 50);
    PathArm task(random_pose(0.5, 0.5), 1, 100, fast);
    task.move(CartesianLine(*task.arm, random_pose(0.5, 0.5),
                            {.speed = 1, .acceleration = 10, .angular_speed = 10, .angular_acceleration = 100}));
    for (std::size_t k = 1; k < task.joints.size(); ++k) {
      const double dt = task.dt();
      const JointVector velocity = (task.joints[k] - task.joints[k - 1]) / dt;
      RC_ASSERT(velocity.cwiseAbs().maxCoeff() <= 0.99 * fast * 1.001);
      if (k < 2) continue;
      const JointVector acceleration = (task.joints[k] - 2 * task.joints[k - 1] + task.joints[k - 2]) / (dt * dt);
      RC_ASSERT(acceleration.cwiseAbs().maxCoeff() <= 0.9 * 10 * fast * 1.001);
    }
  });
}

// a pause ends on the line; a late command leaves it, and the motion continues from the nearest point
TEST(CartesianLine, FollowsTheRestAfterAnInterruption) {
  check_property(kCases, [] {
    const Pose start = random_pose(0.5, 1), target = random_pose(0.5, 1);
    const PathLimits limits = random_limits();
    PathArm task(start, static_cast<std::uint16_t>(pick(1, 10)));
    const bool paused = task.interrupt_at(pick(1, 60)) == PathArm::Interruption::pause;
    task.move(CartesianLine(*task.arm, target, limits));
    RC_ASSERT(task.ending == Ending::generator);
    if (task.commands.empty() || task.resumed_at == 0 || task.resumed_at == task.commands.size()) return;
    RC_ASSERT(fakes::distance(task.commands.back().pose, target) < 1e-12);
    RC_ASSERT(fakes::angle(task.commands.back().pose, target) < 1e-7);
    // from rest, without a jump: at most the distance of the joints' acceleration in a step
    const JointVector first = task.joints[task.resumed_at] - task.rested_at;
    RC_ASSERT(first.cwiseAbs().maxCoeff() <= 0.5 * 1e4 * task.dt() * task.dt());
    if (paused) fakes::assert_tool_motion(task, limits);
    const Vector3d way = target.translation() - start.translation();
    for (std::size_t k = paused ? 0 : task.resumed_at; k < task.commands.size(); ++k) {
      if (task.commands[k].kind != CommandKind::pose) continue;
      const Vector3d gone = task.commands[k].pose.translation() - start.translation();
      if (way.norm() > 0.01) RC_ASSERT(gone.cross(way.normalized()).norm() < 1e-9);
    }
  });
}

TEST(CartesianLine, ComesToRestFirstFromAPresentMotion) {
  check_property(kCases, [] {
    const Pose target = random_pose(0.5, 0.5);
    PathArm task(random_pose(0.5, 0.5), 1, 100, 1);
    JointVector velocity(6);
    velocity << fakes::random_vector(0.3), fakes::random_vector(0.3);
    task.roll(velocity);
    task.move(CartesianLine(*task.arm, target));
    RC_ASSERT(task.ending == Ending::generator);
    RC_ASSERT(fakes::distance(task.commands.back().pose, target) < 1e-12);
    JointVector before = velocity;
    for (std::size_t k = 1; k < task.joints.size(); ++k) {
      const JointVector now = (task.joints[k] - task.joints[k - 1]) / task.dt();
      RC_ASSERT((now - before).cwiseAbs().maxCoeff() <= 10 * 2 * task.dt());  // 10 rad/s^2, over up to two steps
      before = now;
    }
  });
}

TEST(CartesianLine, CommandsNothingAtTheTarget) {
  Pose here = Pose::Identity();
  here.linear() = exp_rotation({0.3, 0.2, 0.1});
  PathArm task(here);
  task.move(CartesianLine(*task.arm, here));
  EXPECT_EQ(task.ending, Ending::generator);
  EXPECT_TRUE(task.commands.empty());
}

TEST(CartesianLine, ImpossiblePathIsRefusedBeforeItsStart) {
  PathArm task(Pose::Identity(), 10, 0.5);
  Pose target = Pose::Identity();
  target.translation().x() = 1;
  try {
    task.move(CartesianLine(*task.arm, target));
    FAIL();
  } catch (const NonFatalError& error) {
    EXPECT_EQ(error.code(), ErrorCode::joint_limit);
    EXPECT_NE(error.detail().find("the path after 51 %"), std::string::npos) << error.detail();
  }
  EXPECT_TRUE(task.commands.empty());
}

TEST(CartesianLine, RefusesInvalidArguments) {
  PathArm task(Pose::Identity());
  const auto make = [&](const Pose& pose, const PathLimits& limits) { CartesianLine{*task.arm, pose, limits}; };
  Pose bad = Pose::Identity();
  bad.linear() *= 2;
  EXPECT_NO_THROW(make(Pose::Identity(), {}));
  EXPECT_THROW(make(bad, {}), NonFatalError);
  EXPECT_THROW(make(Pose::Identity(), {.speed = 0}), NonFatalError);
  EXPECT_THROW(make(Pose::Identity(), {.acceleration = -1}), NonFatalError);
  EXPECT_THROW(make(Pose::Identity(), {.angular_speed = kNan}), NonFatalError);
  EXPECT_THROW(make(Pose::Identity(), {.angular_acceleration = 0}), NonFatalError);
}

}  // namespace
}  // namespace mrroc::cartesian_line_test
