#include "sim/ur/arm_motion.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

namespace mrroc::sim::ur::arm_motion_test {
namespace {

constexpr double kPeriod = 0.002, kBandwidth = 60;

double number(int least, int greatest) { return *rc::gen::inRange(least, greatest) * 1e-3; }

/// Integrates the law of the header in steps so small that they are exact enough.
void integrate(JointTargets::Kind kind, double target, double& x, double& rate) {
  constexpr int kSteps = 20000;
  const double h = kPeriod / kSteps, w = kBandwidth;
  for (int i = 0; i < kSteps; ++i) {
    const double acceleration =
        kind == JointTargets::Kind::position ? w * w * (target - x) - 2 * w * rate : w * (target - rate);
    x += h * rate;
    rate += h * acceleration;
  }
}

RC_GTEST_PROP(ExactJoints, FollowTheirDifferentialEquation, ()) {
  for (const auto kind : {JointTargets::Kind::position, JointTargets::Kind::velocity}) {
    double x = number(-1000, 1000), rate = 0;
    ExactJoints joints(Six{x}, kBandwidth);
    for (int i = 0; i < 5; ++i) {
      const double target = number(-1000, 1000);
      joints.step({kind, Six{target}, Six{target}}, kPeriod);
      integrate(kind, target, x, rate);
      RC_ASSERT(std::abs(joints.position()[0] - x) < 1e-5);
      RC_ASSERT(std::abs(joints.velocity()[0] - rate) < 1e-2);
    }
  }
}

TEST(ExactJoints, BrakesHold) {
  ExactJoints joints(Six{1, 2, 3, 4, 5, 6});
  joints.step({JointTargets::Kind::velocity, {}, Six{1, 1, 1, 1, 1, 1}}, kPeriod);
  const Six before = joints.position();
  joints.step({}, kPeriod);
  EXPECT_EQ(joints.position(), before);
  EXPECT_EQ(joints.velocity(), Six{});
}

/// The arm with its motion, period after period.
struct Arm {
  void step() { joints.step(motion.targets(joints), kPeriod); }
  /// Until no command lasts. Returns the greatest speed of joint 0.
  double finish() {
    double fastest = 0;
    for (int i = 0; i < 10000 && motion.is_moving(); ++i) {
      step();
      fastest = std::max(fastest, std::abs(joints.velocity()[0]));
    }
    return fastest;
  }
  ExactJoints joints{Six{}, kBandwidth};
  ArmMotion motion{kPeriod};
};

TEST(ArmMotion, MovejReachesItsTargetWithinItsSpeed) {
  Arm arm;
  const Six to{1, -0.5, 0, 0.25, 0, 0};
  arm.motion.movej(to, 0.5, 2, arm.joints);
  const double fastest = arm.finish();
  EXPECT_FALSE(arm.motion.is_moving());
  EXPECT_LE(fastest, 0.5 + 1e-9);
  EXPECT_GT(fastest, 0.45);
  for (std::size_t i = 0; i < to.size(); ++i) EXPECT_NEAR(arm.joints.position()[i], to[i], 2e-4) << i;
}

TEST(ArmMotion, MovejToItsOwnPositionEnds) {
  Arm arm;
  arm.motion.movej(Six{}, 0.5, 2, arm.joints);
  arm.finish();
  EXPECT_FALSE(arm.motion.is_moving());
  EXPECT_EQ(arm.joints.position(), Six{});
}

TEST(ArmMotion, StopjDeceleratesToRest) {
  Arm arm;
  for (int i = 0; i < 500; ++i) {
    arm.motion.speedj(Six{1}, 5);
    arm.step();
  }
  EXPECT_NEAR(arm.joints.velocity()[0], 1, 1e-3);
  const double begin = arm.joints.position()[0];
  arm.motion.stopj(4, arm.joints);
  arm.finish();
  EXPECT_FALSE(arm.motion.is_moving());
  // v^2 / 2 a, and what the joints' lag adds: v / w
  EXPECT_NEAR(arm.joints.position()[0] - begin, 1.0 / 8 + 1 / kBandwidth, 5e-3);
  const double end = arm.joints.position()[0];
  for (int i = 0; i < 100; ++i) arm.step();
  EXPECT_NEAR(arm.joints.position()[0], end, 1e-3);
}

TEST(ArmMotion, WithoutACommandTheArmIsHeld) {
  Arm arm;
  arm.motion.servoj(Six{0.1});
  arm.step();
  for (int i = 0; i < 200; ++i) arm.step();
  EXPECT_NEAR(arm.joints.velocity()[0], 0, 1e-6);
  EXPECT_NEAR(arm.joints.position()[0], 0.1, 1e-6);
}

}  // namespace
}  // namespace mrroc::sim::ur::arm_motion_test
