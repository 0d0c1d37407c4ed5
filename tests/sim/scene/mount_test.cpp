// Robots that carry robots.
#include <gtest/gtest.h>
#include <stdlib.h>

#include "sim/simulation.hpp"
#include "sim/worlds.hpp"

namespace mrroc::sim::mount_test {
namespace {

using config::message_of;
using task_test::ScratchFolder;

Pose pose_of(const double* position, const double* matrix) {
  Pose pose = Pose::Identity();
  pose.translation() = Eigen::Map<const Eigen::Vector3d>(position);
  pose.linear() = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(matrix);
  return pose;
}

Pose body(const mjModel& model, const mjData& data, const char* name) {
  const int id = std::max(0, mj_name2id(&model, mjOBJ_BODY, name));
  return pose_of(data.xpos + 3 * id, data.xmat + 9 * id);
}

Pose site(const mjModel& model, const mjData& data, const char* name) {
  const int id = std::max(0, mj_name2id(&model, mjOBJ_SITE, name));
  return pose_of(data.site_xpos + 3 * id, data.site_xmat + 9 * id);
}

const Pose kOffset = at(0.01, 0.02, 0.03, 0.4);

TEST(Mount, CarriedRobotIsInTheToolFrameOfItsCarrierInEveryPosture) {
  // three in a chain, listed from the last one
  const auto model = load_model(compose(kData / "scene.xml", {{"finger", kTwolink, kOffset, false, "hand"},
                                                              {"hand", kTwolink, Pose::Identity(), false, "arm"},
                                                              {"arm", kTwolink, at(1, 2, 0.5, 1.25), false}}));
  const auto data = make_data(*model);
  double angle = 0.1;
  for (const char* joint : {"arm/shoulder", "arm/elbow", "hand/shoulder", "hand/elbow"}) {
    data->qpos[model->jnt_qposadr[mj_name2id(model.get(), mjOBJ_JOINT, joint)]] = angle += 0.3;
  }
  mj_kinematics(model.get(), data.get());
  EXPECT_TRUE(body(*model, *data, "arm").isApprox(at(1, 2, 0.5, 1.25), 1e-14));
  EXPECT_TRUE(body(*model, *data, "hand").isApprox(site(*model, *data, "arm/tool"), 1e-14));
  EXPECT_TRUE(body(*model, *data, "finger").isApprox(site(*model, *data, "hand/tool") * kOffset, 1e-14));
  EXPECT_GT((body(*model, *data, "hand").translation() - body(*model, *data, "arm").translation()).norm(), 0.5);
}

/// Two blocks of 0.2 m in one place with a joint between them; a robot mounted on the tool site is in the same place.
constexpr const char* kMountedBlock = R"(<mujoco>
<compiler angle="radian"/>
<worldbody><body name="base"><geom name="base" type="box" size="0.1 0.1 0.1" mass="1"/>
<body name="link"><joint name="j" type="slide"/><geom name="link" type="box" size="0.1 0.1 0.1" mass="1"/>
<site name="tool"/></body></body></worldbody>
</mujoco>)";

TEST(Mount, CarrierAndCarriedMayOverlapButBothCollideWithOtherBodies) {
  const ScratchFolder scratch;
  const auto hand = scratch.write("hand.xml", kMountedBlock);
  // MuJoCo has no neighbours of bodies that are rigidly joined to the world
  std::string text = kMountedBlock;
  text.insert(text.find("<geom"), "<joint name='lift' type='slide'/>");
  const auto arm = scratch.write("arm.xml", text);
  const auto scene = scratch.write("scene.xml", R"(<mujoco><compiler angle="radian"/>
<worldbody><body name="ball"><freejoint/><geom name="ball" size="0.1"/></body></worldbody></mujoco>)");
  const auto model = load_model(compose(scene, {{"arm", arm}, {"hand", hand, Pose::Identity(), false, "arm"}}));
  const auto data = make_data(*model);
  mj_forward(model.get(), data.get());
  std::vector<std::string> touching;
  for (int i = 0; i < data->ncon; ++i) {
    std::string pair = mj_id2name(model.get(), mjOBJ_GEOM, data->contact[i].geom1);
    pair += std::string(" and ") + mj_id2name(model.get(), mjOBJ_GEOM, data->contact[i].geom2);
    if (pair.find("ball") == std::string::npos) touching.push_back(pair);
  }
  for (const std::string& pair : touching)
    EXPECT_EQ(pair, "arm/base and hand/link") << "all other pairs are neighbours";
  EXPECT_FALSE(touching.empty()) << "overlapping blocks touch";
  EXPECT_GT(data->ncon, static_cast<int>(touching.size())) << "the ball touches nothing";
}

TEST(Mount, CarrierWithoutAToolIsNamedWithItsFile) {
  const ScratchFolder scratch;
  std::string bare = kMountedBlock;
  bare.erase(bare.find("<site"), std::string("<site name=\"tool\"/>").size());
  const auto scene = scratch.write("scene.xml", kEmptyScene);
  const std::vector<RobotPart> robots{
      {"arm", scratch.write("bare.xml", bare)},
      {"hand", scratch.write("block.xml", kMountedBlock), Pose::Identity(), false, "arm"}};
  EXPECT_EQ(message_of(scratch.path(), [&] { compose(scene, robots); }),
            "bare.xml:1: robots.hand.mount: there is no site \"tool\" to carry it, expected <site name=\"tool\"/> in "
            "this file");
}

TEST(Mount, CarriersWristMeasuresTheWeightOfTheCarriedRobot) {
  setenv("MRROC_SHARE", kData.c_str(), 1);
  config::Deployment deployment = twolink_deployment(2);
  deployment.robots[1].mount = "a0";
  const auto memory = std::make_unique<world::WorldMemory>();
  Simulation simulation(deployment, *memory);
  simulation.publish_initial();
  simulation.step(1);
  RawReading wrist;
  ASSERT_TRUE(memory->readings[1].load(wrist));
  const mjModel& model = simulation.world().model();
  const double mass = model.body_subtreemass[mj_name2id(&model, mjOBJ_BODY, "a0/hand")];
  EXPECT_GT(mass, 4);
  EXPECT_NEAR(Eigen::Vector3d(wrist.values[0], wrist.values[1], wrist.values[2]).norm(), mass * 9.81, 1e-5);
}

}  // namespace
}  // namespace mrroc::sim::mount_test
