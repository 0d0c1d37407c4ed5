#include "language/joints/axis_stop.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <ruckig/ruckig.hpp>

#include "edp/random_values.hpp"

namespace mrroc::edp::axis_stop_test {
namespace {

TEST(AxisStop, KeepsTheLimitsAndIsContinuous) {
  EXPECT_TRUE(rc::check([] {
    const double p0 = number(-3, 3), v0 = number(-2, 2), a0 = number(-8, 8);
    const double limit = number(0.5, 10), jerk = number(5, 500);
    AxisStop stop;
    stop.plan(p0, v0, a0, limit, jerk);
    const int samples = 500;
    const double h = stop.duration() / samples;
    double p = p0, v = v0, a = a0, fastest = std::abs(v0);
    for (int k = 0; k <= samples; ++k) {
      double p1, v1, a1;
      stop.at(k == samples ? stop.duration() : k * h, p1, v1, a1);
      const double t = k == 0 ? 0 : h;
      RC_ASSERT(std::abs(a1) <= std::max(limit, std::abs(a0)) + 1e-9);
      RC_ASSERT(std::abs(a1 - a) <= jerk * t * (1 + 1e-6) + 1e-9);
      RC_ASSERT(std::abs(v1 - v - 0.5 * (a + a1) * t) <= 0.25 * jerk * t * t + 1e-9);
      RC_ASSERT(std::abs(p1 - p - 0.5 * (v + v1) * t) <= 0.25 * std::max(limit, std::abs(a0)) * t * t + 1e-9);
      RC_ASSERT(p1 >= stop.lowest() - 1e-9);
      RC_ASSERT(p1 <= stop.highest() + 1e-9);
      fastest = std::max(fastest, std::abs(v1));
      p = p1, v = v1, a = a1;
    }
    RC_ASSERT(v == 0.0);
    RC_ASSERT(a == 0.0);
    RC_ASSERT(p == stop.end_position());
    RC_ASSERT(std::abs(stop.fastest()) >= fastest - 1e-9);
    RC_ASSERT(std::abs(stop.fastest()) <= fastest + jerk * h * h + 1e-9);
  }));
}

TEST(AxisStop, EqualsTheTimeOptimalStopOfRuckig) {
  ruckig::Ruckig<1> oracle;
  EXPECT_TRUE(rc::check([&oracle] {
    ruckig::InputParameter<1> input;
    ruckig::Trajectory<1> trajectory;
    input.control_interface = ruckig::ControlInterface::Velocity;
    input.current_position = {number(-3, 3)};
    input.current_velocity = {number(-2, 2)};
    input.current_acceleration = {number(-8, 8)};
    input.max_acceleration = {number(0.5, 10)};
    input.max_jerk = {number(5, 500)};
    RC_ASSERT(oracle.calculate(input, trajectory) == ruckig::Result::Working);
    AxisStop stop;
    stop.plan(input.current_position[0], input.current_velocity[0], input.current_acceleration[0],
              input.max_acceleration[0], input.max_jerk[0]);
    RC_ASSERT(std::abs(stop.duration() - trajectory.get_duration()) < 1e-9);
    for (int k = 0; k <= 10; ++k) {
      const double t = stop.duration() * k / 10;
      double p, v, a, expected_p = 0, expected_v = 0, expected_a = 0;
      stop.at(t, p, v, a);
      trajectory.at_time(t, expected_p, expected_v, expected_a);
      RC_ASSERT(std::abs(p - expected_p) < 1e-8);
      RC_ASSERT(std::abs(v - expected_v) < 1e-8);
    }
  }));
}

TEST(AxisStop, StaysAtRest) {
  AxisStop stop;
  stop.plan(1.5, 0, 0, 5, 100);
  EXPECT_EQ(stop.duration(), 0);
  EXPECT_EQ(stop.end_position(), 1.5);
  EXPECT_EQ(stop.fastest(), 0);
}

}  // namespace
}  // namespace mrroc::edp::axis_stop_test
