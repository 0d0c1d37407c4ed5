#include "edp/quintic.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "random_values.hpp"

namespace mrroc::edp {
namespace {

TEST(Quintic, LeadsFromTheStartStateToTheEndState) {
  EXPECT_TRUE(rc::check([] {
    const DesiredState from = random_state(3), to = random_state(3);
    const double duration = number(0.002, 5);
    Quintic path;
    path.plan(from, to, duration);
    const auto same = [duration](const DesiredState& a, const DesiredState& b) {
      // the polynomial is conditioned on positions; its derivatives carry 1/D and 1/D^2
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

}  // namespace
}  // namespace mrroc::edp
