#include "drivers/loopback/loopback_hardware.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "edp/rig.hpp"

namespace mrroc::edp {
namespace {

constexpr double kIncrement = 2 * std::numbers::pi / 4000;

TEST(LoopbackHardware, StartsAtHomeWithinOneEncoderIncrement) {
  const Slide model;
  LoopbackHardware hardware(model, kPeriod);
  HardwareInput input;
  hardware.read(0, input);
  EXPECT_NEAR(input.motors[0], 25, kIncrement / 2);
  EXPECT_TRUE(input.synchronised);
  EXPECT_EQ(input.fault, ErrorCode::none);
}

// J dw/dt = k_t i - b w with constant current: w = k_t i / b (1 - exp(-b t / J))
TEST(LoopbackHardware, FollowsItsDifferentialEquation) {
  const Slide model;
  LoopbackHardware hardware(model, kPeriod);
  HardwareInput input;
  hardware.enable(true);
  hardware.read(0, input);
  hardware.write(0, one(4));
  const double final_velocity = 0.105 * 4 / 0.02, time_constant = 1.5e-4 / 0.02;
  for (Tick k = 1; k <= 50; ++k) {
    hardware.read(k, input);
    const double t = static_cast<double>(k) * kPeriod;
    const double expected = 25 + final_velocity * (t - time_constant * (1 - std::exp(-t / time_constant)));
    EXPECT_NEAR(input.motors[0], expected, kIncrement);
    EXPECT_EQ(input.current[0], 4);
  }
}

TEST(LoopbackHardware, BrakesHoldWhileItIsDisabled) {
  const Slide model;
  LoopbackHardware hardware(model, kPeriod);
  HardwareInput input;
  hardware.read(0, input);
  const double start = input.motors[0];
  hardware.write(0, one(10));
  hardware.read(100, input);
  EXPECT_EQ(input.motors[0], start);
  EXPECT_EQ(input.current[0], 0);
}

TEST(LoopbackHardware, CurrentIsKeptWithinTheMotorLimit) {
  const Slide model;
  LoopbackHardware hardware(model, kPeriod);
  HardwareInput input;
  hardware.enable(true);
  hardware.read(0, input);
  hardware.write(0, one(1000));
  hardware.read(1, input);
  EXPECT_EQ(input.current[0], 20);
}

TEST(LoopbackHardware, RefusesAMotorWithoutInertia) {
  Slide model;
  model.change().axes[0].rotor_inertia = 0;
  EXPECT_THROW(LoopbackHardware(model, kPeriod), SystemError);
}

// original's defect 25: the test mode's measured position was the commanded one
TEST(LoopbackHardware, MeasuredLagsCommandedWhileMovingAndSettles) {
  Rig<Slide> rig;
  ASSERT_FALSE(rig.send(joint_command(one(0.75), 1000, 500)));
  rig.run(500);
  const double lag = rig.seen().desired.position[0] - rig.seen().joints[0];
  EXPECT_GT(lag, 1e-4);
  EXPECT_LT(lag, 0.02);
  rig.run(2000);
  EXPECT_NEAR(rig.seen().joints[0], 0.75, 1e-4);  // a few encoder increments of 1.6e-5
}

}  // namespace
}  // namespace mrroc::edp
