#include "edp/servo/regulator.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "edp/test_robots.hpp"

namespace mrroc::edp::regulator_test {
namespace {

constexpr double kCounts = 4000 / (2 * std::numbers::pi);

/// Increments of the shaft, given in encoder counts.
double step(Regulator& regulator, double commanded, double measured) {
  return regulator.step(commanded / kCounts, measured / kCounts);
}

// the law of `mrrocpp` 4.1 written out for the first three ticks
TEST(Regulator, EqualsTheServoLawOfTheOriginal) {
  const AxisParameters axis = test_axis("x");
  const double a = axis.regulator_a, b0 = axis.regulator_b0, b1 = axis.regulator_b1, eps = axis.regulator_eps;
  Regulator regulator(axis);
  const double e1 = (1 + eps) * 10;
  const double u1 = b0 * e1;
  EXPECT_NEAR(step(regulator, 10, 0), 0.2 * u1, 1e-12);
  const double e2 = e1 + (1 + eps) * 6 - (1 - eps) * 10;
  const double u2 = (1 + a) * u1 + b0 * e2 - b1 * e1;
  EXPECT_NEAR(step(regulator, 10, 4), 0.2 * u2, 1e-12);
  const double e3 = e2 + (1 + eps) * -2 - (1 - eps) * 6;
  const double u3 = (1 + a) * u2 - a * u1 + b0 * e3 - b1 * e2;
  EXPECT_NEAR(step(regulator, 10, 12), 0.2 * u3, 1e-12);
}

TEST(Regulator, OutputAndCurrentAreKeptWithinTheirLimits) {
  AxisParameters axis = test_axis("x");
  Regulator by_output(axis);
  for (int i = 0; i < 20; ++i) step(by_output, 1000, 0);
  EXPECT_EQ(step(by_output, 1000, 0), 20);  // 190 * 0.2 A = 38 A, the motor's limit is 20 A
  axis.current_max = 100;
  Regulator regulator(axis);
  for (int i = 0; i < 20; ++i) EXPECT_LE(std::abs(step(regulator, -1000, 0)), 190 * 0.2);
  EXPECT_EQ(step(regulator, -1000, 0), -190 * 0.2);
}

TEST(Regulator, ResetClearsItsState) {
  Regulator regulator(test_axis("x"));
  for (int i = 0; i < 5; ++i) step(regulator, 10, 3);
  regulator.reset();
  EXPECT_EQ(step(regulator, 0, 0), 0);
}

// original's defect 9: gains given with the axis were overwritten by constants in every step
TEST(Regulator, ItsGainsAreThoseOfTheAxis) {
  AxisParameters axis = test_axis("x");
  axis.regulator_b0 = 2;
  axis.regulator_eps = 0;
  axis.regulator_current_gain = 0.5;
  Regulator regulator(axis);
  EXPECT_NEAR(step(regulator, 3, 0), 0.5 * 2 * 3, 1e-12);
}

// at rest under gravity the output is constant: another gain must not change the current
TEST(Regulator, NewParametersDoNotChangeTheCurrentAbruptly) {
  const AxisParameters axis = test_axis("x");
  AxisParameters soft = axis;
  soft.regulator_current_gain = axis.regulator_current_gain / 3;
  soft.regulator_a = 0.2;
  Regulator regulator(axis);
  for (int i = 0; i < 4; ++i) step(regulator, 2, 1);
  double before = 0;
  for (int i = 0; i < 200; ++i) before = step(regulator, 0, i < 50 ? 0.01 : 0);
  Regulator kept = regulator;
  regulator.use(soft);
  EXPECT_NEAR(step(regulator, 0, 0), step(kept, 0, 0), 1e-2 * std::abs(before));
  EXPECT_NE(before, 0);
  Regulator fresh(soft);
  EXPECT_NEAR(step(fresh, 10, 0), soft.regulator_current_gain * soft.regulator_b0 * (1 + soft.regulator_eps) * 10,
              1e-12);
}

}  // namespace
}  // namespace mrroc::edp::regulator_test
