#include "drivers/loopback/regulated_loopback.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "edp/rig.hpp"

namespace mrroc::edp {
namespace {

using Interface = DriveParameters::Interface;

constexpr double kBandwidth = 15;  // Hz
constexpr double kResolution = 2 * std::numbers::pi / 4000;

Slide slide(Interface interface) {
  Slide model;
  model.change().drives = {interface, kBandwidth, 20};
  return model;
}

/// Integrates the law of the header in steps so small that they are exact enough.
struct Integrated {
  double angle, velocity = 0;
  void follow(Interface interface, double target, double rate, double seconds) {
    const double w = 2 * std::numbers::pi * kBandwidth;
    constexpr int kSteps = 20000;
    const double h = seconds / kSteps;
    for (int i = 0; i < kSteps; ++i) {
      const double lag = rate - velocity;
      const double acceleration =
          interface == Interface::position ? w * w * (target + rate * i * h - angle) + 2 * w * lag : w * lag;
      angle += h * velocity + h * h * acceleration / 2;
      velocity += h * acceleration;
    }
  }
};

TEST(RegulatedLoopback, FollowsItsDifferentialEquation) {
  for (const Interface interface : {Interface::position, Interface::velocity}) {
    const Slide model = slide(interface);
    RegulatedLoopback hardware(model, kPeriod);
    HardwareInput input;
    hardware.enable(true);
    hardware.read(0, input);
    Integrated shaft{25};
    for (Tick k = 0; k < 20; ++k) {
      const double target = 25.5 + 0.02 * static_cast<double>(k), rate = k < 10 ? 10 : -3;
      const double correction = interface == Interface::velocity ? 20 * (target - shaft.angle) : 0;
      hardware.set_points(one(target), one(rate));
      hardware.write(k, one(0));
      shaft.follow(interface, target, rate + correction, kPeriod);
      hardware.read(k + 1, input);
      EXPECT_NEAR(input.motors[0], shaft.angle, kResolution / 2 + 1e-5) << k;
    }
  }
}

TEST(RegulatedLoopback, BrakesHoldWhileItIsDisabled) {
  const Slide model = slide(Interface::position);
  RegulatedLoopback hardware(model, kPeriod);
  HardwareInput input;
  hardware.read(0, input);
  hardware.set_points(one(30), one(10));
  hardware.read(100, input);
  EXPECT_NEAR(input.motors[0], 25, kResolution / 2);
  EXPECT_FALSE(hardware.follows_current());
}

/// The positions that it reports before synchronisation have another origin.
TEST(RegulatedLoopback, SetPointsAreInThePositionsThatItReports) {
  const Slide model = slide(Interface::position);
  RegulatedLoopback hardware(model, kPeriod, false);
  HardwareInput input;
  hardware.enable(true);
  hardware.read(0, input);
  EXPECT_EQ(input.motors[0], 0);
  hardware.set_points(one(1), one(0));
  hardware.read(500, input);
  EXPECT_NEAR(input.motors[0], 1, kResolution);
  hardware.set_origin(one(7));
  hardware.set_points(one(8), one(0));
  hardware.read(1000, input);
  EXPECT_NEAR(input.motors[0], 8, kResolution);
  EXPECT_TRUE(input.synchronised);
}

}  // namespace
}  // namespace mrroc::edp
