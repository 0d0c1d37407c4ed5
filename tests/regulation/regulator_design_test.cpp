#include "regulation/regulator_design.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>

#include "edp/servo/regulator.hpp"
#include "regulation/servo_loop.hpp"

namespace mrroc::regulation {
namespace {

constexpr double kPeriod = 0.002;
constexpr double kDegree = std::numbers::pi / 180;

/// An axis behind a gear, with a random motor and load.
struct RandomDrive {
  explicit RandomDrive(std::mt19937_64& random) {
    const auto power = [&random](double least, double greatest) {
      return std::exp(std::uniform_real_distribution(std::log(least), std::log(greatest))(random));
    };
    gear = power(1, 200);
    axis.torque_constant = power(0.05, 2);
    axis.rotor_inertia = power(1e-5, 1e-2);
    axis.inertia_min = power(0.01, 5);
    axis.inertia_max = power(1, 3) * axis.inertia_min;
    axis.viscous_friction = power(1e-3, 10) * axis.rotor_inertia;
    axis.encoder_increments = power(1000, 1e6);
    axis.current_max = 1e9;  // the law is linear
    axis.regulator_bandwidth = power(1, 12);
    design_regulator(axis, gear, kPeriod);
  }
  AxisParameters axis;
  double gear = 1;
};

/// Whether the shaft comes to rest after it was knocked, by the law of the EDP and the differential equation of the
/// motor; the current acts one period late.
bool comes_to_rest(const AxisParameters& axis, double inertia) {
  constexpr int kTicks = 40000, kWindow = 4000;
  constexpr double kKnock = 1e-3, kRest = 1e-12;  // rad/s, rad
  edp::Regulator regulator(axis);
  const double rate = axis.viscous_friction / inertia, fading = -std::expm1(-rate * kPeriod);
  double position = 0, velocity = kKnock, current = 0, measured = 0, before = 0, last = 0;
  for (int tick = 0; tick < kTicks; ++tick) {
    const double next = regulator.step(0, position - measured);
    measured = position;
    const double final = axis.torque_constant / axis.viscous_friction * current;
    position += final * kPeriod + (velocity - final) * fading / rate;
    velocity += (final - velocity) * fading;
    current = next;
    if (std::abs(position) > 1) return false;
    if (tick >= kWindow && tick < 2 * kWindow) before = std::max(before, std::abs(position));
    if (tick >= kTicks - kWindow) last = std::max(last, std::abs(position));
  }
  return last < std::max(before, kRest);
}

TEST(RegulatorDesign, HasTheCrossoverAndThePhaseThatItPromises) {
  std::mt19937_64 random(1);
  std::printf("seed 1\n");
  for (int round = 0; round < 200; ++round) {
    const RandomDrive drive(random);
    const double turn = 2 * std::numbers::pi * drive.axis.regulator_bandwidth * kPeriod;
    const LoopMargins margins = ServoLoop(drive.axis, design_inertia(drive.axis, drive.gear), kPeriod).margins();
    ASSERT_TRUE(margins.stable) << round;
    EXPECT_NEAR(margins.crossover, drive.axis.regulator_bandwidth, 0.01 * drive.axis.regulator_bandwidth) << round;
    // friction only adds to it
    EXPECT_GT(margins.phase_margin, 57 * kDegree - 1.5 * turn) << round;
    EXPECT_GT(margins.gain_increase, 2) << round;
    EXPECT_LT(margins.gain_decrease, 0.2) << round;
  }
}

/// The margins are those of the law itself: a little within them a knock fades, a little beyond it grows.
TEST(RegulatorDesign, TheLoopIsStableJustAsFarAsItsMarginsSay) {
  std::mt19937_64 random(2);
  std::printf("seed 2\n");
  for (int round = 0; round < 20; ++round) {
    const RandomDrive drive(random);
    // friction changes with the inertia's time constant: the plant of the margins has none to speak of
    AxisParameters axis = drive.axis;
    axis.viscous_friction = 1e-3 * axis.rotor_inertia;
    const double inertia = design_inertia(axis, drive.gear);
    const LoopMargins margins = ServoLoop(axis, inertia, kPeriod).margins();
    EXPECT_TRUE(comes_to_rest(axis, 1.2 * inertia / margins.gain_increase)) << round;
    EXPECT_FALSE(comes_to_rest(axis, 0.8 * inertia / margins.gain_increase)) << round;
    EXPECT_TRUE(comes_to_rest(axis, 0.8 * inertia / margins.gain_decrease)) << round;
    EXPECT_FALSE(comes_to_rest(axis, 1.2 * inertia / margins.gain_decrease)) << round;
    for (const double factor : {1.1, 0.9}) {
      EXPECT_EQ(ServoLoop(axis, factor * inertia / margins.gain_increase, kPeriod).margins().stable, factor > 1);
      EXPECT_EQ(ServoLoop(axis, factor * inertia / margins.gain_decrease, kPeriod).margins().stable, factor < 1);
    }
  }
}

TEST(RegulatorDesign, InertiaIsThatOfTheRotorAndOfWhatTheGearMoves) {
  AxisParameters axis;
  axis.rotor_inertia = 2e-4;
  axis.inertia_min = 1;
  axis.inertia_max = 4;
  EXPECT_DOUBLE_EQ(shaft_inertia(axis, 1, -100), 3e-4);
  EXPECT_DOUBLE_EQ(design_inertia(axis, 100), std::sqrt(3e-4 * 6e-4));
}

}  // namespace
}  // namespace mrroc::regulation
