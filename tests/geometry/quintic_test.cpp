#include "geometry/quintic.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "edp/random_values.hpp"

namespace mrroc::edp {
namespace {

TEST(Quintic, ConnectsTheStartAndTheEndState) {
  EXPECT_TRUE(rc::check([] {
    const DesiredState from = random_state(3), to = random_state(3);
    const double duration = number(0.002, 5);
    Quintic path;
    path.plan(from, to, duration);
    const auto same = [duration](const DesiredState& a, const DesiredState& b) {
      // the rounding errors are those of positions; derivatives multiply them by 1/D and 1/D^2
      RC_ASSERT((a.position - b.position).norm() < 1e-11);
      RC_ASSERT((a.velocity - b.velocity).norm() < 1e-11 * (1 + 1 / duration));
      RC_ASSERT((a.acceleration - b.acceleration).norm() < 1e-11 * (1 + 1 / (duration * duration)));
    };
    same(path.at(0), from);
    same(path.at(duration), to);
  }));
}

TEST(Quintic, ItsVelocityAndAccelerationAreTheDerivativesOfItsPosition) {
  EXPECT_TRUE(rc::check([] {
    const DesiredState from = random_state(2), to = random_state(2);
    Quintic path;
    path.plan(from, to, 1.0);
    const double t = number(0.1, 0.9), h = 1e-4;
    const DesiredState before = path.at(t - h), here = path.at(t), after = path.at(t + h);
    RC_ASSERT(((after.position - before.position) / (2 * h) - here.velocity).norm() < 1e-4);
    RC_ASSERT(((after.velocity - before.velocity) / (2 * h) - here.acceleration).norm() < 1e-3);
  }));
}

TEST(Quintic, ItsBoundsHoldOnTheWholePath) {
  EXPECT_TRUE(rc::check([] {
    const DesiredState from = random_state(3), to = random_state(3);
    const double duration = number(0.002, 5);
    Quintic path;
    path.plan(from, to, duration);
    const Quintic::Bounds bounds = path.bounds();
    JointVector before = path.at(0).acceleration;
    for (int k = 0; k <= 100; ++k) {
      const DesiredState state = path.at(duration * k / 100);
      for (int i = 0; i < 3; ++i) {
        RC_ASSERT(std::abs(state.position[i] - from.position[i]) <= bounds.position[i] + 1e-9);
        RC_ASSERT(std::abs(state.velocity[i]) <= bounds.velocity[i] * (1 + 1e-9));
        RC_ASSERT(std::abs(state.acceleration[i]) <= bounds.acceleration[i] * (1 + 1e-9));
        const double change = std::abs(state.acceleration[i] - before[i]);
        RC_ASSERT(change <= bounds.jerk[i] * duration / 100 * (1 + 1e-9) + 1e-9 * bounds.acceleration[i]);
      }
      before = state.acceleration;
    }
  }));
}

// otherwise they would save no samples
TEST(Quintic, ItsBoundsAreTightOnAShortPieceOfASmoothMotion) {
  const double duration = 0.002, velocity = 0.3, acceleration = 0.5;
  DesiredState from = DesiredState::resting_at(JointVector::Constant(1, 1.0));
  from.velocity[0] = velocity;
  from.acceleration[0] = acceleration;
  DesiredState to = from;
  to.position[0] += duration * (velocity + duration * acceleration / 2);
  to.velocity[0] += duration * acceleration;
  Quintic path;
  path.plan(from, to, duration);
  EXPECT_NEAR(path.bounds().position[0], to.position[0] - from.position[0], 1e-9);
  EXPECT_NEAR(path.bounds().velocity[0], to.velocity[0], 1e-6);
  EXPECT_NEAR(path.bounds().acceleration[0], acceleration, 1e-3);
  EXPECT_LT(path.bounds().jerk[0], 1);
}

}  // namespace
}  // namespace mrroc::edp
