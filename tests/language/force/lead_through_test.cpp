#include "mrroc/generators/lead_through.hpp"

#include <limits>

#include "language/force/force_flyer.hpp"
#include "language/property.hpp"
#include "language/random_values.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/move.hpp"

namespace mrroc::lead_through_test {
namespace {

using Eigen::Vector3d;
using fakes::check_property;
using fakes::ForceFlyer;
using fakes::pick;
using fakes::random_vector;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Guidance random_guidance() {
  Guidance guidance;
  guidance.damping = pick(50, 500);
  guidance.angular_damping = 0.1 * pick(10, 200);
  guidance.mass = pick(1, 20);
  guidance.inertia = 0.01 * pick(1, 50);
  guidance.speed = 0.01 * pick(2, 30);
  guidance.angular_speed = 0.01 * pick(5, 100);
  guidance.load = {0.1 * pick(0, 50), random_vector(0.1)};
  return guidance;
}

/// A hand that pushes and turns with a constant wrench, in tool axes, and the weight of the load.
ForceFlyer::Environment hand(const Wrench& wrench, const Load& load) {
  return [=](const Pose& pose, const Twist&) { return Wrench{wrench + weight_of(load, pose.linear())}; };
}

// the remaining force moves it against the damper, up to the speed limit
double speed_of(double force, double threshold, double damping, double most) {
  return std::min(most, std::max(0.0, force - threshold) / damping);
}

TEST(LeadThrough, MovesWithTheHandAsFastAsTheDamperAllows) {
  check_property(100, [] {
    const Guidance guidance = random_guidance();
    Wrench pushed = Wrench::Zero();  // a rotation at the same time would bend the path: one after the other
    const bool turn = pick(0, 1) == 1;
    (turn ? pushed.tail<3>() : pushed.head<3>()) = random_vector(turn ? 5 : 60);
    ForceFlyer task(Pose::Identity(), hand(pushed, guidance.load), static_cast<std::uint16_t>(pick(1, 10)), 1);
    double fastest = 0, turned_fastest = 0;
    task.on_tick = [&](Tick, const Wrench&) {
      fastest = std::max(fastest, task.twist.head<3>().norm());
      turned_fastest = std::max(turned_fastest, task.twist.tail<3>().norm());
    };
    const double settled = guidance.mass / guidance.damping + guidance.inertia / guidance.angular_damping;
    const auto steps = static_cast<std::uint64_t>((10 * settled + 0.5) / task.arm->step_duration());
    Move({*task.arm}, {}, LeadThrough{*task.arm, guidance}.until(ElapsedSteps{steps}));
    const double linear = speed_of(pushed.head<3>().norm(), 2, guidance.damping, guidance.speed);
    const double angular = speed_of(pushed.tail<3>().norm(), 0.2, guidance.angular_damping, guidance.angular_speed);
    // the weight is compensated for a pose that is up to 2 N - v ticks old; a rotation since then acts like the hand
    const double age = 2 * task.arm->step_duration();
    const double tilting = 9.81 * guidance.load.mass * angular * age;
    RC_ASSERT(std::abs(task.twist.head<3>().norm() - linear) < 0.02 * linear + 1e-6 + tilting / guidance.damping);
    RC_ASSERT(std::abs(task.twist.tail<3>().norm() - angular) <
              0.02 * angular + 1e-6 + 0.2 * tilting / guidance.angular_damping);
    RC_ASSERT(fastest <= guidance.speed * 1.001 + tilting / guidance.damping);
    RC_ASSERT(turned_fastest <= guidance.angular_speed * 1.001 + 0.2 * tilting / guidance.angular_damping);
    if (linear > 0) RC_ASSERT(task.twist.head<3>().normalized().dot(pushed.head<3>().normalized()) > 0.999);
  });
}

TEST(LeadThrough, StaysWhereItIsReleasedWithAnyLoad) {
  check_property(100, [] {
    Guidance guidance = random_guidance();
    Wrench noise;
    noise << random_vector(1), random_vector(0.1);  // below the thresholds
    ForceFlyer task(Pose::Identity(), hand(noise, guidance.load));
    Move({*task.arm}, {}, LeadThrough{*task.arm, guidance}.until(ElapsedSteps{200}));
    RC_ASSERT(task.pose.isApprox(Pose::Identity(), 1e-9));
  });
}

TEST(LeadThrough, FixedAxesStay) {
  check_property(100, [] {
    Guidance guidance;
    std::fill(guidance.free.begin(), guidance.free.end(), false);
    const int axis = pick(0, 5);
    guidance.free[static_cast<std::size_t>(axis)] = true;
    Wrench pushed;
    pushed << random_vector(40), random_vector(4);
    pushed[axis] = axis < 3 ? 20 : 2;
    ForceFlyer task(Pose::Identity(), hand(pushed, {}));
    Move({*task.arm}, {}, LeadThrough{*task.arm, guidance}.until(ElapsedSteps{50}));
    Twist moved;
    moved << task.pose.translation(), rotation_vector(task.pose.linear());
    RC_ASSERT(moved[axis] > 0.01);
    moved[axis] = 0;
    RC_ASSERT(moved.norm() < 1e-9);
  });
}

// the bound in the header: a force within a step is damped only from the next one on
TEST(LeadThrough, BlowWithinAStepExceedsTheSpeedAtMostByItsImpulse) {
  Guidance guidance;
  double push = 0;
  ForceFlyer task(Pose::Identity(), [&](const Pose&, const Twist&) {
    Wrench wrench = Wrench::Zero();
    wrench[0] = push;
    return wrench;
  });
  double fastest = 0;
  Tick first = 0;
  task.on_tick = [&](Tick tick, const Wrench&) {
    if (first == 0) first = tick;
    push = tick - first > 103 ? 80 : 0;
    fastest = std::max(fastest, task.twist[0]);
  };
  Move({*task.arm}, {}, LeadThrough{*task.arm, guidance}.until(ElapsedSteps{100}));
  EXPECT_LE(fastest, guidance.speed + 80 * task.arm->step_duration() / guidance.mass);
  EXPECT_NEAR(task.twist[0], guidance.speed, 1e-3);
}

TEST(LeadThrough, RefusesInvalidArguments) {
  ForceFlyer task(Pose::Identity(), hand(Wrench::Zero(), {}));
  const auto with = [&](auto change) {
    Guidance guidance;
    change(guidance);
    LeadThrough{*task.arm, guidance};
  };
  EXPECT_NO_THROW(with([](auto&) {}));
  EXPECT_THROW(with([](auto& g) { g.free.fill(false); }), NonFatalError);
  for (const double bad : {0.0, -1.0, kNan}) {
    EXPECT_THROW(with([&](auto& g) { g.damping = bad; }), NonFatalError);
    EXPECT_THROW(with([&](auto& g) { g.angular_damping = bad; }), NonFatalError);
    EXPECT_THROW(with([&](auto& g) { g.speed = bad; }), NonFatalError);
    EXPECT_THROW(with([&](auto& g) { g.angular_speed = bad; }), NonFatalError);
  }
  for (const double bad : {-1.0, kNan}) {
    EXPECT_THROW(with([&](auto& g) { g.mass = bad; }), NonFatalError);
    EXPECT_THROW(with([&](auto& g) { g.inertia = bad; }), NonFatalError);
    EXPECT_THROW(with([&](auto& g) { g.force_threshold = bad; }), NonFatalError);
    EXPECT_THROW(with([&](auto& g) { g.torque_threshold = bad; }), NonFatalError);
    EXPECT_THROW(with([&](auto& g) { g.load.mass = bad; }), NonFatalError);
  }
}

}  // namespace
}  // namespace mrroc::lead_through_test
