// The stop of several robots on their common way: its law, its limits, and that of one robot's joints.
#include "language/stops/common_stop_path.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

#include "edp/random_values.hpp"
#include "language/fakes.hpp"
#include "language/property.hpp"
#include "language/random_values.hpp"
#include "language/stops/common_stop.hpp"

namespace mrroc::common_stop_path_test {
namespace {

using edp::number;
using edp::random_state;
using edp::random_vector;
using fakes::check_property;
using fakes::FakeTask;
using fakes::pick;

constexpr double kPeriod = 0.002;

/// Its desired state, at rest at 0.
RobotState& resting(Robot& robot) {
  RobotState& state = robot.exchanged_state();
  state.desired_joints = state.desired_velocity = state.desired_acceleration = JointVector::Zero(6);
  return state;
}

CommonStop any_stop() { return {static_cast<std::uint16_t>(pick(1, 600)), number(-8, 8)}; }

TEST(CommonStopPath, LeadsFromTheStateToRestWithoutASkip) {
  check_property(300, [] {
    const DesiredState from = random_state(3);
    const CommonStop stop = any_stop();
    CommonStopPath path;
    path.plan(from, stop, kPeriod);
    const double duration = stop.ticks * kPeriod, h = duration / 2000;
    RC_ASSERT((path.at(0).position - from.position).isZero(1e-12));
    RC_ASSERT((path.at(0).velocity - from.velocity).isZero(1e-12));
    RC_ASSERT((path.at(0).acceleration - from.acceleration).isZero(1e-9));
    for (int k = 1; k < 2000; ++k) {
      const DesiredState before = path.at((k - 1) * h), now = path.at(k * h), after = path.at((k + 1) * h);
      const double fast = 1 + now.velocity.cwiseAbs().maxCoeff() + now.acceleration.cwiseAbs().maxCoeff();
      const double sharp = 60 * fast / (duration * duration) + 60 * fast / duration;
      RC_ASSERT(((after.position - before.position) / (2 * h) - now.velocity).isZero(sharp * h * h + 1e-9));
      RC_ASSERT(((after.velocity - before.velocity) / (2 * h) - now.acceleration)
                    .isZero(sharp * h * h * (1 + 1 / duration) + 1e-7));
    }
    RC_ASSERT(path.ticks() == stop.ticks);
    RC_ASSERT(path.at(duration).at_rest());
    RC_ASSERT(path.at(duration).position == path.end().position);
    RC_ASSERT(path.at(duration + 1).position == path.end().position);
    RC_ASSERT((path.at(duration * (1 - 1e-9)).position - path.end().position).isZero(1e-6));
  });
}

// what two robots have in common at the start they have until the end
TEST(CommonStopPath, KeepsEveryLinearRelationOfTheJoints) {
  check_property(300, [] {
    const DesiredState from = random_state(3);
    const double factor = number(-3, 3);
    const DesiredState other{random_vector(3, 2), factor * from.velocity, factor * from.acceleration};
    const CommonStop stop = any_stop();
    CommonStopPath first, second;
    first.plan(from, stop, kPeriod);
    second.plan(other, stop, kPeriod);
    for (int k = 0; k <= 20; ++k) {
      const double t = stop.ticks * kPeriod * k / 20;
      const JointVector way = first.at(t).position - from.position;
      RC_ASSERT((second.at(t).position - other.position - factor * way).isZero(1e-12));
    }
  });
}

// a straight way is not left, and nothing turns back on it
TEST(CommonStopPath, StaysOnAStraightWay) {
  check_property(300, [] {
    DesiredState from = random_state(3);
    const double rate = number(-4, 4);
    from.acceleration = rate * from.velocity;
    CommonStopPath path;
    const auto ticks =
        static_cast<std::uint16_t>(pick(1, static_cast<int>(3 / std::max(0.3, std::abs(rate)) / kPeriod)));
    path.plan(from, {ticks, rate}, kPeriod);
    double before = 0;
    for (int k = 1; k <= ticks; ++k) {
      const JointVector way = path.at(k * kPeriod).position - from.position;
      const double along = way.dot(from.velocity) / from.velocity.squaredNorm();
      RC_ASSERT((way - along * from.velocity).isZero(1e-12));
      RC_ASSERT(along >= before - 1e-15);
      before = along;
    }
  });
}

TEST(CommonStop, TakesMostOfTheLimitsOfTheRobotThatNeedsLongest) {
  check_property(300, [] {
    FakeTask task;
    const auto a = task.robot("a"), b = task.robot("b");
    double share = 0;
    for (Robot* robot : {a.get(), b.get()}) resting(*robot).desired_velocity = random_vector(6, 1);
    const CommonStop stop = common_stop({a.get(), b.get()}, kPeriod);
    RC_ASSERT(stop.rate == 0);
    for (Robot* robot : {a.get(), b.get()}) {
      const RobotState& state = robot->exchanged_state();
      CommonStopPath path;
      path.plan({state.desired_joints, state.desired_velocity, state.desired_acceleration}, stop, kPeriod);
      JointVector before = state.desired_acceleration;
      for (int k = 1; k <= stop.ticks; ++k) {
        const JointVector now = path.at(k * kPeriod).acceleration;
        share = std::max(share, now.cwiseAbs().maxCoeff() / 4);
        share = std::max(share, (now - before).cwiseAbs().maxCoeff() / kPeriod / 40);
        before = now;
      }
    }
    RC_ASSERT(share <= 0.8 + 1e-9);
    RC_ASSERT(share >= 0.75);
  });
}

TEST(CommonStop, TakesNoLongerThanRobotsThatBrakeAlready) {
  FakeTask task;
  const auto a = task.robot("a"), b = task.robot("b");
  resting(*b);
  resting(*a).desired_velocity[0] = 0.2;
  a->exchanged_state().desired_acceleration[0] = -2;
  const CommonStop stop = common_stop({a.get(), b.get()}, kPeriod);
  EXPECT_NEAR(stop.rate, -10, 0.1);
  EXPECT_NEAR(stop.ticks, 150, 1);
}

TEST(CommonStop, IsNoneAtRest) {
  FakeTask task;
  const auto a = task.robot("a"), b = task.robot("b");
  resting(*a);
  resting(*b);
  EXPECT_EQ(common_stop({a.get(), b.get()}, kPeriod).ticks, 0);
}

}  // namespace
}  // namespace mrroc::common_stop_path_test
