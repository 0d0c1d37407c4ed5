#include "sim/scene/joint_servo.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/world.hpp"
#include "sim/worlds.hpp"

namespace mrroc::sim::joint_servo_test {
namespace {

using Kind = world::JointDrive::Kind;

constexpr double kStep = 0.001;
constexpr double kBandwidth = 90;  // rad/s

/// The two-link arm under gravity, with drives that regulate on their own.
class Servoed {
 public:
  explicit Servoed(int substeps = 1) : world(composition(), substeps * kStep, kStep) {
    JointVector home(2);
    home << 0.5, 0.8;
    world.attach("a", {"shoulder", "elbow"}, home);
    world.start();
    drive.tick = 1;
    drive.enabled = 1;
    drive.joint_count = 2;
    drive.kind = Kind::position;
    drive.bandwidth = kBandwidth;
    drive.position = {0.5, 0.8};
    drive.torque_max.fill(1e9);
  }

  void step() {
    world.drive(0, drive, ++tick);
    world.step(tick);
    world.measure(0, seen);
  }

  World world;
  world::JointDrive drive{};
  world::JointMeasurement seen{};
  Tick tick = 0;

 private:
  static Composition composition() { return compose(kData / "empty.xml", {{"a", kTwolink, Pose::Identity(), false}}); }
};

/// Whatever the posture, its gravity and the other joint do.
TEST(JointServo, AFreeJointHasTheBandwidth) {
  Servoed arm;
  arm.drive.position = {0.7, 0.5};
  const double p = std::exp(-kBandwidth * kStep);
  double error[2] = {0.2, -0.3}, lag[2] = {0, 0};
  for (int k = 0; k < 300; ++k) {
    arm.step();
    for (std::size_t i = 0; i < 2; ++i) {
      lag[i] = p * p * lag[i] - (1 - p) * (1 - p) / kStep * error[i];
      error[i] += kStep * lag[i];
      EXPECT_NEAR(arm.seen.position[i], arm.drive.position[i] - error[i], 1e-10) << k;
    }
  }
  EXPECT_LT(std::abs(error[0]), 1e-8);
}

TEST(JointServo, ASteadyMotionIsFollowedWithoutError) {
  Servoed arm(2);
  arm.drive.velocity = {0.4, -0.3};
  for (int k = 0; k < 500; ++k) {
    arm.step();
    for (std::size_t i = 0; i < 2; ++i) arm.drive.position[i] += 2 * kStep * arm.drive.velocity[i];
  }
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(arm.seen.position[i], arm.drive.position[i], 1e-9);
    EXPECT_NEAR(arm.seen.velocity[i], arm.drive.velocity[i], 1e-9);
  }
}

TEST(JointServo, InterfaceVelocityFollowsVelocitiesOnly) {
  Servoed arm;
  arm.drive.kind = Kind::velocity;
  arm.drive.velocity = {0.4, -0.3};
  arm.drive.position = {5, 5};
  double lag = 0.4;
  for (int k = 0; k < 200; ++k) {
    arm.step();
    lag *= std::exp(-kBandwidth * kStep);
    EXPECT_NEAR(arm.seen.velocity[0], 0.4 - lag, 1e-10) << k;
  }
}

/// A force at the hand bends the arm: (r - q) M kp is the torque that holds it.
TEST(JointServo, AForceBendsTheArmByItsStiffness) {
  Servoed arm;
  const mjModel& model = arm.world.model();
  const int hand = mj_name2id(&model, mjOBJ_BODY, "a/hand");
  arm.world.data().xfrc_applied[6 * hand] = 30;
  for (int k = 0; k < 1000; ++k) arm.step();
  double held[2] = {0, 0}, jacobian[6];
  mj_jac(&model, &arm.world.data(), jacobian, nullptr, arm.world.data().xipos + 3 * hand, hand);
  for (int i = 0; i < 2; ++i) held[i] = -30 * jacobian[i];
  double bent[2];
  mj_solveM(&model, &arm.world.data(), bent, held, 1);
  const double p = std::exp(-kBandwidth * kStep), stiffness = (1 - p) * (1 - p) / (kStep * kStep);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(arm.drive.position[i] - arm.seen.position[i], bent[i] / stiffness, 1e-6) << i;
    EXPECT_GT(std::abs(bent[i] / stiffness), 1e-4) << "it is not rigid";
  }
}

TEST(JointServo, TorquesAreHeldWithinTheirLimits) {
  Servoed arm;
  arm.drive.torque_max = {5, 2};
  arm.drive.position = {2, 2};
  for (int k = 0; k < 100; ++k) {
    arm.step();
    EXPECT_LE(std::abs(arm.seen.torque[0]), 5);
    EXPECT_LE(std::abs(arm.seen.torque[1]), 2);
  }
  EXPECT_EQ(arm.seen.torque[1], 2);
}

TEST(JointServo, BrakesHoldWhateverTheSetPointIs) {
  Servoed arm;
  arm.step();
  arm.world.brake(0);
  for (int k = 0; k < 100; ++k) arm.world.step(++arm.tick);
  arm.world.measure(0, arm.seen);
  EXPECT_NEAR(arm.seen.position[0], 0.5, 1e-9);
  EXPECT_EQ(arm.seen.torque[0], 0);
}

}  // namespace
}  // namespace mrroc::sim::joint_servo_test
