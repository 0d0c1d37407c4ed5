#include <gtest/gtest.h>

#include <limits>

#include "mrroc/errors.hpp"
#include "reference_dynamics.hpp"
#include "sim/world.hpp"
#include "worlds.hpp"

namespace mrroc::sim::world_failures_test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using task_test::ScratchFolder;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Runs `action`, which must throw SystemError (simulator) with `tick`; returns its message.
template <class Action>
std::string simulator_error(Tick tick, Action action) {
  try {
    action();
  } catch (const SystemError& error) {
    EXPECT_EQ(error.code(), ErrorCode::simulator);
    EXPECT_EQ(error.origin().tick, tick);
    EXPECT_EQ(error.origin().process, "sim");
    return error.what();
  }
  ADD_FAILURE() << "no error";
  return "";
}

#define EXPECT_CONTAINS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

class WorldFailure : public testing::Test {
 protected:
  WorldFailure() : world_(compose(kData / "scene.xml", {{"a", kTwolink, at(0, 0, 0.5), false}}), 0.002, 0.001) {
    JointVector home(2);
    home << 0.5, 0.8;
    world_.attach("a", {"shoulder", "elbow"}, home);
    world_.start();
    for (Tick k = 1; k <= 5; ++k) world_.step(k);
  }
  world::JointDrive drive() const {
    return drive_of(MatrixXd::Identity(2, 2), MatrixXd::Zero(2, 2), VectorXd::Zero(2), VectorXd::Zero(2));
  }
  World world_;
};

TEST_F(WorldFailure, NonFiniteDrivesAreRefusedWithRobotAndJoint) {
  for (const double bad : {kNan, std::numeric_limits<double>::infinity()}) {
    world::JointDrive torque = drive(), inertia = drive(), damping = drive(), bias = drive();
    torque.torque[1] = bad;
    inertia.rotor_inertia[kMaxJoints + 1] = bad;
    damping.damping[kMaxJoints] = bad;
    bias.bias[1] = bad;
    for (const world::JointDrive& each : {torque, inertia, damping, bias}) {
      const std::string message = simulator_error(6, [&] { world_.drive(0, each, 6); });
      EXPECT_CONTAINS(message, "the drive of joint 2 is not finite");
      EXPECT_CONTAINS(message, "device a");
    }
  }
}

TEST_F(WorldFailure, RefusesADriveForAnotherNumberOfJoints) {
  world::JointDrive three = drive();
  three.joint_count = 3;
  EXPECT_CONTAINS(simulator_error(6, [&] { world_.drive(0, three, 6); }), "3 joints, expected 2");
}

TEST_F(WorldFailure, WorldThatResetItselfIsAnErrorWithTheJoint) {
  world::JointDrive huge = drive();
  huge.torque[0] = 1e30;
  world_.drive(0, huge, 6);
  const std::string message = simulator_error(6, [&] { world_.step(6); });
  EXPECT_CONTAINS(message, "joint a/shoulder diverged");
}

TEST_F(WorldFailure, NonFinitePositionsAndVelocitiesNameTheBodyOfAFreeJoint) {
  const int ball = mj_name2id(&world_.model(), mjOBJ_BODY, "ball");
  const int joint = world_.model().body_jntadr[ball];
  world_.data().qvel[world_.model().jnt_dofadr[joint] + 1] = kNan;
  EXPECT_CONTAINS(simulator_error(6, [&] { world_.step(6); }), "body ball diverged");
}

TEST_F(WorldFailure, NonFinitePositionsNameTheJoint) {
  const int joint = mj_name2id(&world_.model(), mjOBJ_JOINT, "box");
  world_.data().qpos[world_.model().jnt_qposadr[joint] + 2] = kNan;
  EXPECT_CONTAINS(simulator_error(6, [&] { world_.step(6); }), "joint box diverged");
}

TEST(WorldFailures, NonFiniteControlsAreAnError) {
  const ScratchFolder scratch;
  const std::string scene =
      "<mujoco><worldbody><body><joint name='j'/><geom size='0.1'/></body></worldbody>"
      "<actuator><motor joint='j'/></actuator></mujoco>";
  World world(compose_texts(scratch, scene), 0.001, 0.001);
  world.start();
  world.data().ctrl[0] = kNan;
  EXPECT_CONTAINS(simulator_error(1, [&] { world.step(1); }), "control 0 is not finite");
}

TEST(WorldFailures, TooManyContactsAndTooManyConstraintsAreErrors) {
  const ScratchFolder scratch;
  const auto crowded = [&](const std::string& size) {
    std::string scene = "<mujoco><size " + size + "/><worldbody><geom type='plane' size='1 1 1'/>";
    for (int i = 0; i < 8; ++i) {
      scene += "<body pos='" + std::to_string(i) + " 0 0.09'><freejoint/><geom type='box' size='.1 .1 .1'/></body>";
    }
    World world(compose_texts(scratch, scene + "</worldbody></mujoco>"), 0.001, 0.001);
    world.start();
  };
  EXPECT_CONTAINS(simulator_error(0, [&] { crowded("nconmax='4'"); }), "nconmax");
  EXPECT_CONTAINS(simulator_error(0, [&] { crowded("njmax='4' nconmax='100'"); }), "njmax");
  EXPECT_NO_THROW(crowded("njmax='500' nconmax='100'"));
}

TEST(WorldFailures, WarningsAreCountedAndKeepTheirFirstTick) {
  const ScratchFolder scratch;
  World world(compose_texts(scratch, kEmptyScene), 0.002, 0.001);
  world.start();
  // a callback represents any warning from MuJoCo
  mjcb_passive = [](const mjModel*, mjData* data) {
    if (data->time > 0.0095) mju_warning("the belt squeaks");
  };
  for (Tick k = 1; k <= 10; ++k) world.step(k);
  mjcb_passive = nullptr;
  ASSERT_EQ(world.warnings().size(), 1U);
  EXPECT_EQ(world.warnings()[0].text, "the belt squeaks");
  EXPECT_EQ(world.warnings()[0].first_tick, 5U);
  EXPECT_GE(world.warnings()[0].count, 10U);
}

TEST(WorldFailures, RefusesAnotherIntegratorThanEuler) {
  const ScratchFolder scratch;
  EXPECT_THROW(World(compose_texts(scratch, "<mujoco><option integrator='RK4'/></mujoco>"), 0.001, 0.001),
               config::ConfigurationError);
}

TEST(WorldFailures, MissingJointNamesThoseThatExist) {
  World world(compose(kData / "scene.xml", {{"a", kTwolink, Pose::Identity(), false}}), 0.002, 0.001);
  try {
    world.attach("a", {"shoulder", "wrist"}, JointVector::Zero(2));
    FAIL() << "no error";
  } catch (const config::ConfigurationError& error) {
    EXPECT_STREQ(error.what(), "robots.a: no joint \"wrist\" in its MJCF, expected one of shoulder, elbow");
  }
}

}  // namespace
}  // namespace mrroc::sim::world_failures_test
