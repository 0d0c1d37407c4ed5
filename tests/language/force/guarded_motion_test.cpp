#include "mrroc/generators/guarded_motion.hpp"

#include <limits>

#include "language/force/force_flyer.hpp"
#include "language/property.hpp"
#include "language/random_values.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/conditions/travelled.hpp"
#include "mrroc/move.hpp"

namespace mrroc::guarded_motion_test {
namespace {

using Eigen::Vector3d;
using fakes::check_property;
using fakes::ForceFlyer;
using fakes::pick;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Vector3d random_direction() {
  return Vector3d(0.1 * pick(-10, 10), 0.1 * pick(-10, 10), 0.1 * pick(2, 10)).normalized();
}

struct Approach {
  Vector3d velocity = 0.005 * pick(1, 10) * random_direction();
  double force = pick(1, 10);
  double stiffness = 1000 * pick(1, 10);
  double distance = 0.001 * pick(5, 60);
  fakes::SpringSurface surface = fakes::plane(distance * velocity.normalized(), -velocity, stiffness);
};

TEST(GuardedMotion, EndsAtAContactAndPressesAtMostTwiceTheForce) {
  check_property(100, [] {
    const Approach approach;
    const auto n = static_cast<std::uint16_t>(pick(1, 20));
    ForceFlyer task(Pose::Identity(), approach.surface, n, static_cast<std::uint16_t>(pick(1, n)));
    const double speed = approach.velocity.norm();
    double most = 0, fastest = 0;
    task.on_tick = [&](Tick, const Wrench& wrench) {
      most = std::max(most, wrench.head<3>().norm());
      fastest = std::max(fastest, task.twist.head<3>().norm());
    };
    GuardedMotion motion(*task.arm, approach.velocity, approach.force);
    const Outcome end = Move({*task.arm}, {}, motion.until(ElapsedSteps{20000}));
    RC_ASSERT(end.ending == Ending::generator);
    RC_ASSERT(motion.touched().has_value());
    const double inside = motion.touched()->translation().dot(approach.velocity.normalized()) - approach.distance;
    // b m and the sampling of the law let it overshoot its final force slightly
    const double bound = 2 * approach.force + approach.stiffness * speed * (0.01 + task.servo_period());
    RC_ASSERT(approach.stiffness * inside >= approach.force - 1e-6);
    RC_ASSERT(approach.stiffness * inside <= bound);
    RC_ASSERT(most <= bound);
    RC_ASSERT(fastest <= speed + 1e-9);
  });
}

// the law itself stops the tool, even with a late task
TEST(GuardedMotion, PressesWithTwiceTheForceWithoutATask) {
  check_property(50, [] {
    const Approach approach;
    ForceFlyer task(Pose::Identity(), approach.surface, 5000, 1);  // ten seconds without a check by the task
    const double damping = approach.velocity.norm() / (2 * approach.force);
    GuardedMotion motion(*task.arm, approach.velocity, approach.force, 100);
    Move({*task.arm}, {}, motion.until(ElapsedSteps{2}));
    const double settled = approach.distance / approach.velocity.norm() + 5 / (approach.stiffness * damping);
    if (settled < 9)
      RC_ASSERT(std::abs(task.arm->state().wrench.head<3>().norm() - 2 * approach.force) < 0.02 * approach.force);
  });
}

TEST(GuardedMotion, CommandsNothingInContact) {
  ForceFlyer task(Pose::Identity(), fakes::plane({0, 0, -0.01}, {0, 0, -1}));
  GuardedMotion motion(*task.arm, {0, 0, 0.01}, 5);
  EXPECT_EQ(Move({*task.arm}, {}, motion).steps, 0u);
  EXPECT_TRUE(motion.touched().has_value());
  GuardedMotion away(*task.arm, {0, 0, -0.01}, 5);
  EXPECT_TRUE(Move({*task.arm}, {}, away.until(Travelled{*task.arm, 0.02})).by<Travelled>())
      << "a force away from the surface is not a contact";
  EXPECT_FALSE(away.touched().has_value());
}

TEST(GuardedMotion, ContinuesWithoutAContactAndRampsItsVelocityUp) {
  ForceFlyer task(Pose::Identity(), [](const Pose&, const Twist&) { return Wrench{Wrench::Zero()}; });
  double before = 0, steepest = 0;
  task.on_tick = [&](Tick, const Wrench&) {
    const double now = task.twist.head<3>().norm();
    steepest = std::max(steepest, (now - before) / task.servo_period());
    before = now;
  };
  GuardedMotion motion(*task.arm, {0.03, 0, 0.04}, 5, 0.1);
  const Outcome end = Move({*task.arm}, {}, motion.until(Travelled{*task.arm, 0.1}));
  EXPECT_TRUE(end.by<Travelled>());
  EXPECT_FALSE(motion.touched().has_value());
  EXPECT_LE(task.twist.head<3>().norm(), 0.05 + 1e-9);
  EXPECT_NEAR(task.twist.head<3>().norm(), 0.05, 1e-6);
  EXPECT_LT(steepest, 0.1 * task.arm->step_duration() / 0.01) << "a step of the velocity through the low-pass";
}

TEST(GuardedMotion, OtherAxesKeepTheirPositionUnderAnyForce) {
  ForceFlyer task(Pose::Identity(), [](const Pose&, const Twist&) {
    Wrench wrench;
    wrench << 30, -20, 0, 3, 2, 1;
    return wrench;
  });
  Move({*task.arm}, {}, GuardedMotion{*task.arm, {0, 0, 0.02}, 5}.until(ElapsedSteps{50}));
  EXPECT_LT(task.pose.translation().head<2>().norm(), 1e-12);
  EXPECT_TRUE(task.pose.linear().isIdentity(1e-12));
}

TEST(GuardedMotion, RefusesInvalidArguments) {
  ForceFlyer task(Pose::Identity(), [](const Pose&, const Twist&) { return Wrench{Wrench::Zero()}; });
  const auto make = [&](const Vector3d& velocity, double force, double acceleration) {
    GuardedMotion{*task.arm, velocity, force, acceleration};
  };
  EXPECT_NO_THROW(make({0, 0, 0.01}, 5, 0.2));
  EXPECT_THROW(make(Vector3d::Zero(), 5, 0.2), NonFatalError);
  EXPECT_THROW(make({0, kNan, 0}, 5, 0.2), NonFatalError);
  for (const double bad : {0.0, -1.0, kNan}) {
    EXPECT_THROW(make({0, 0, 0.01}, bad, 0.2), NonFatalError);
    EXPECT_THROW(make({0, 0, 0.01}, 5, bad), NonFatalError);
  }
}

}  // namespace
}  // namespace mrroc::guarded_motion_test
