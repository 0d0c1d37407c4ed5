#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "mrroc/errors.hpp"
#include "reference_dynamics.hpp"
#include "sim/world.hpp"
#include "worlds.hpp"

namespace mrroc::sim::drive_physics_test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using task_test::ScratchFolder;

std::string pendulum(double armature, double damping) {
  return "<mujoco><compiler angle='radian'/><worldbody><body name='b'>"
         "<joint name='j' axis='0 1 0' limited='true' range='-2 0.6' armature='" +
         std::to_string(armature) + "' damping='" + std::to_string(damping) +
         "'/><geom type='capsule' fromto='0 0 0 0.1 0 -0.5' size='0.02' mass='1'/></body></worldbody></mujoco>";
}

JointVector values(std::initializer_list<double> list) {
  JointVector vector(static_cast<Eigen::Index>(list.size()));
  std::copy(list.begin(), list.end(), vector.data());
  return vector;
}

TEST(DrivePhysics, OneJointMovesAsWithMujocosOwnArmatureAndDamping) {
  constexpr double kArmature = 0.3, kDamping = 0.25, kStep = 0.001;
  const ScratchFolder scratch;
  const Composition composition = compose_texts(scratch, kEmptyScene, {{"p", pendulum(kArmature, kDamping)}});

  const Model model = load_model(composition);  // MuJoCo's version
  const Data data = make_data(*model);
  model->opt.timestep = kStep;
  data->qpos[0] = -1.9;

  World world(composition, kStep, kStep);  // the framework's version
  world.attach("p", {"j"}, values({-1.9}));
  world.start();
  const MatrixXd b = MatrixXd::Constant(1, 1, kArmature), d = MatrixXd::Constant(1, 1, kDamping);

  double worst = 0;
  bool at_limit = false;
  for (Tick k = 1; k <= 3000; ++k) {
    mj_step(model.get(), data.get());
    world.drive(0, drive_of(b, d, VectorXd::Zero(1), VectorXd::Zero(1)), k);
    world.step(k);
    worst = std::max(worst, std::abs(data->qpos[0] - world.data().qpos[0]));
    at_limit = at_limit || data->nefc > 0;
  }
  std::cout << "largest difference from MuJoCo's own armature: " << worst << " rad\n";
  EXPECT_LT(worst, 1e-12);
  EXPECT_TRUE(at_limit) << "the comparison must include the joint's limit";
}

/// The coupled inertia, damping and torques of a two-joint transmission.
struct TwoLink {
  MatrixXd b = (MatrixXd(2, 2) << 0.8, -0.35, -0.35, 0.5).finished();
  MatrixXd d = (MatrixXd(2, 2) << 0.9, 0.3, 0.3, 0.4).finished();
  VectorXd tau = (VectorXd(2) << 3, -2).finished();
  VectorXd c = (VectorXd(2) << 0.4, 0.7).finished();
};

Composition two_link_world() { return compose(kData / "empty.xml", {{"a", kTwolink, Pose::Identity(), false}}); }

TEST(DrivePhysics, CoupledInertiaAndDampingAgreeWithDenseMatrices) {
  constexpr double kStep = 0.001;
  const TwoLink drives;
  ReferenceDynamics reference(load_model(two_link_world()), kStep);
  World world(two_link_world(), 2 * kStep, kStep);
  world.attach("a", {"shoulder", "elbow"}, values({0.5, 0.8}));
  world.start();
  reference.data().qpos[0] = 0.5;
  reference.data().qpos[1] = 0.8;
  double worst = 0;
  for (Tick k = 1; k <= 1000; ++k) {
    world.drive(0, drive_of(drives.b, drives.d, drives.tau, drives.c), k);
    world.step(k);
    for (int i = 0; i < 2; ++i) reference.step(drives.b, drives.d, drives.tau, drives.c);
    for (int i = 0; i < 2; ++i) {
      worst = std::max(worst, std::abs(world.data().qpos[i] - reference.data().qpos[i]));
      worst = std::max(worst, std::abs(world.data().qvel[i] - reference.data().qvel[i]));
    }
  }
  std::cout << "largest difference from dense matrices: " << worst << " rad or rad/s\n";
  EXPECT_LT(worst, 1e-9);
  EXPECT_GT(std::abs(reference.data().qpos[0] - 0.5), 0.1) << "nothing moved";
}

/// Largest change of energy while the undamped arm swings freely for a second.
double energy_error(double timestep) {
  const TwoLink drives;
  ReferenceDynamics energy(load_model(two_link_world()), timestep);
  World world(two_link_world(), timestep, timestep);
  world.attach("a", {"shoulder", "elbow"}, values({1.0, 0.8}));
  world.start();
  const auto present = [&] {
    std::copy_n(world.data().qpos, 2, energy.data().qpos);
    std::copy_n(world.data().qvel, 2, energy.data().qvel);
    return energy.energy(drives.b);
  };
  const double initial = present();
  double worst = 0;
  for (Tick k = 1; k <= static_cast<Tick>(1.0 / timestep); ++k) {
    world.drive(0, drive_of(drives.b, MatrixXd::Zero(2, 2), VectorXd::Zero(2), VectorXd::Zero(2)), k);
    world.step(k);
    worst = std::max(worst, std::abs(present() - initial));
  }
  return worst;
}

TEST(DrivePhysics, EnergyOfAFreeArmWithCoupledRotorsIsKeptToFirstOrder) {
  const double coarse = energy_error(1e-3), fine = energy_error(1e-4);
  std::cout << "energy error at 1 ms: " << coarse << " J, at 0.1 ms: " << fine << " J\n";
  EXPECT_LT(coarse, 0.05);  // J, of some 10 J that are exchanged
  EXPECT_NEAR(coarse / fine, 10.0, 1.5);
}

TEST(DrivePhysics, RefusesACouplingOfBranches) {
  const ScratchFolder scratch;
  const std::string fork =
      "<mujoco><compiler angle='radian'/><worldbody><body name='root'>"
      "<body name='l'><joint name='l'/><geom size='.1'/></body>"
      "<body name='r' pos='1 0 0'><joint name='r'/><geom size='.1'/></body></body></worldbody></mujoco>";
  World world(compose_texts(scratch, kEmptyScene, {{"f", fork}}), 0.001, 0.001);
  world.attach("f", {"l", "r"}, values({0, 0}));
  world.start();
  MatrixXd b = MatrixXd::Identity(2, 2);
  const auto drive = [&] { return drive_of(b, MatrixXd::Zero(2, 2), VectorXd::Zero(2), VectorXd::Zero(2)); };
  EXPECT_NO_THROW(world.drive(0, drive(), 1));
  b(0, 1) = b(1, 0) = 0.1;
  EXPECT_THROW(world.drive(0, drive(), 1), SystemError);
}

TEST(DrivePhysics, TwoSlidesOfOneBodyMayBeCoupled) {
  // MuJoCo classifies such a body as "simple" and would factor M as a diagonal matrix
  const ScratchFolder scratch;
  const std::string gantry =
      "<mujoco><compiler angle='radian'/><worldbody><body name='g'><joint name='x' type='slide' axis='1 0 0'/>"
      "<joint name='y' type='slide' axis='0 1 0'/><geom size='.1' mass='2'/></body></worldbody></mujoco>";
  World world(compose_texts(scratch, kEmptyScene, {{"g", gantry}}), 0.001, 0.001);
  world.attach("g", {"x", "y"}, values({0, 0}));
  world.start();
  const MatrixXd b = (MatrixXd(2, 2) << 1, 0.5, 0.5, 1).finished();
  world.drive(0, drive_of(b, MatrixXd::Zero(2, 2), VectorXd::Unit(2, 0), VectorXd::Zero(2)), 1);
  world.step(1);
  const Eigen::Vector2d expected = 0.001 * (b + 2 * MatrixXd::Identity(2, 2)).inverse() * Eigen::Vector2d(1, 0);
  EXPECT_NEAR(world.data().qvel[0], expected[0], 1e-15);
  EXPECT_NEAR(world.data().qvel[1], expected[1], 1e-15);
}

TEST(DrivePhysics, BrakesHoldAPushedArmAndReleaseItAgain) {
  World world(two_link_world(), 0.002, 0.001);
  world.attach("a", {"shoulder", "elbow"}, values({0.5, 0.8}));
  world.start();
  const TwoLink drives;
  const auto go = [&](Tick tick) {
    world.drive(0, drive_of(drives.b, drives.d, drives.tau, drives.c), tick);
    world.step(tick);
  };
  for (Tick k = 1; k <= 50; ++k) world.step(k);
  EXPECT_EQ(world.data().qpos[0], 0.5);
  for (Tick k = 51; k <= 100; ++k) go(k);
  EXPECT_GT(std::abs(world.data().qvel[0]), 0.01);
  const double stopped = world.data().qpos[0];
  world.brake(0);
  const int hand = mj_name2id(&world.model(), mjOBJ_BODY, "a/hand");
  world.data().xfrc_applied[6 * hand + 2] = 500;  // N
  for (Tick k = 101; k <= 150; ++k) world.step(k);
  EXPECT_EQ(world.data().qpos[0], stopped);
  EXPECT_EQ(world.data().qvel[0], 0);
  world.data().xfrc_applied[6 * hand + 2] = 0;
  for (Tick k = 151; k <= 200; ++k) go(k);
  EXPECT_NE(world.data().qpos[0], stopped);
}

TEST(DrivePhysics, FollowingJointStartsAtThePositionOfItsEquality) {
  const ScratchFolder scratch;
  const std::string gripper =
      "<mujoco><compiler angle='radian'/><worldbody>"
      "<body name='l'><joint name='l' type='slide' ref='0.1'/><geom size='.01'/></body>"
      "<body name='r' pos='1 0 0'><joint name='r' type='slide' ref='-0.2'/><geom size='.01'/></body></worldbody>"
      "<equality><joint joint1='r' joint2='l' polycoef='0.01 -0.5 2 0 0'/></equality></mujoco>";
  World world(compose_texts(scratch, kEmptyScene, {{"g", gripper}}), 0.001, 0.001);
  world.attach("g", {"l"}, values({0.4}));
  world.start();
  const double expected = -0.2 + 0.01 - 0.5 * 0.3 + 2 * 0.3 * 0.3;
  EXPECT_NEAR(world.data().qpos[1], expected, 1e-15);
  ASSERT_EQ(world.data().nefc, 1);
  EXPECT_NEAR(world.data().efc_pos[0], 0, 1e-15) << "MuJoCo has another equality";
}

TEST(DrivePhysics, EndlessBeltCarriesAPartAndStaysUnderIt) {
  const ScratchFolder scratch;
  const std::string conveyor =
      "<mujoco><compiler angle='radian'/><worldbody><body name='belt'><joint name='belt' type='slide' axis='1 0 0'/>"
      "<geom type='box' size='1 0.2 0.05' mass='20' friction='1'/></body></worldbody>"
      "<custom><tuple name='endless'><element objtype='joint' objname='belt'/></tuple></custom>"
      "<sensor><jointpos name='position' joint='belt'/><jointvel name='velocity' joint='belt'/></sensor></mujoco>";
  const std::string scene =
      "<mujoco><compiler angle='radian'/><worldbody><body name='part' pos='-0.8 0 0.1'><freejoint/>"
      "<geom type='box' size='.05 .05 .05' mass='0.5'/></body></worldbody></mujoco>";
  World world(compose_texts(scratch, scene, {{"conveyor", conveyor}}), 0.002, 0.001);
  world.attach("conveyor", {"belt"}, values({3.0}));
  world.start();
  // terminal speed 0.2 m/s: force 200 N against damping 1000 N s/m
  const auto drive = drive_of(MatrixXd::Constant(1, 1, 100), MatrixXd::Constant(1, 1, 1000), VectorXd::Constant(1, 200),
                              VectorXd::Zero(1));
  const int part = mj_name2id(&world.model(), mjOBJ_BODY, "part");
  for (Tick k = 1; k <= 3000; ++k) {
    world.drive(0, drive, k);
    world.step(k);
  }
  world::JointMeasurement measurement{};
  world.measure(0, measurement);
  EXPECT_NEAR(measurement.velocity[0], 0.2, 1e-3);
  EXPECT_NEAR(measurement.position[0], 3.0 + 0.2 * 6 - 0.2 * 0.12, 2e-3);
  const int belt = mj_name2id(&world.model(), mjOBJ_BODY, "conveyor/belt");
  EXPECT_EQ(world.data().xpos[3 * belt], 0.0);
  EXPECT_NEAR(world.data().xpos[3 * part], -0.8 + (measurement.position[0] - 3.0), 0.01);
  EXPECT_EQ(world.data().sensordata[0], measurement.position[0]) << "an encoder counts the travel";
  EXPECT_EQ(world.data().sensordata[1], measurement.velocity[0]);
}

}  // namespace
}  // namespace mrroc::sim::drive_physics_test
