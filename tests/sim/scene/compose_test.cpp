#include "sim/scene/compose.hpp"

#include <gtest/gtest.h>

#include "sim/worlds.hpp"

namespace mrroc::sim::compose_test {
namespace {

using config::message_of;
using task_test::ScratchFolder;

constexpr const char* kBlock = R"(<mujoco>
<compiler angle="radian"/>
<worldbody><body name="b"><joint name="j" type="slide"/><geom name="g" size="0.1" mass="1"/></body></worldbody>
</mujoco>)";

Eigen::Vector3d body_position(const mjModel& model, const mjData& data, const char* name) {
  const int id = mj_name2id(&model, mjOBJ_BODY, name);
  EXPECT_GE(id, 0) << name;
  return Eigen::Map<const Eigen::Vector3d>(data.xpos + 3 * std::max(id, 0));
}

TEST(Compose, TwoRobotsOfOneTypeStandAtTheirPosesInTheDeployment) {
  const Pose second = at(1, 2, 0.5, 1.25);
  const auto model = load_model(
      compose(kData / "scene.xml", {{"left", kTwolink, at(0, 0, 0.5), false}, {"right", kTwolink, second, false}}));
  const auto data = make_data(*model);
  mj_kinematics(model.get(), data.get());
  EXPECT_LT((body_position(*model, *data, "left/lower") - Eigen::Vector3d(0, 0, 1)).norm(), 1e-15);
  EXPECT_LT((body_position(*model, *data, "right") - second.translation()).norm(), 1e-15);

  const int joint = mj_name2id(model.get(), mjOBJ_JOINT, "right/shoulder");
  data->qpos[model->jnt_qposadr[joint]] = 0.7;
  mj_kinematics(model.get(), data.get());
  const Eigen::Vector3d expected = second * Eigen::Vector3d(0.5 * std::sin(0.7), 0, 0.5 * std::cos(0.7));
  EXPECT_LT((body_position(*model, *data, "right/lower") - expected).norm(), 1e-14);
}

TEST(Compose, EveryKindOfNameIsPrefixedAndRefersToItsOwnRobot) {
  const auto model = load_model(
      compose(kData / "scene.xml", {{"left", kTwolink, at(0, 0, 1), false}, {"right", kTwolink, at(1, 0, 1), false}}));
  for (const std::string robot : {"left", "right"}) {
    for (const auto& [type, name] : {std::pair{mjOBJ_BODY, "hand"},
                                     {mjOBJ_JOINT, "elbow"},
                                     {mjOBJ_GEOM, "upper"},
                                     {mjOBJ_SITE, "wrist"},
                                     {mjOBJ_MATERIAL, "steel"},
                                     {mjOBJ_SENSOR, "encoder"}}) {
      EXPECT_GE(mj_name2id(model.get(), type, (robot + "/" + name).c_str()), 0) << robot << "/" << name;
    }
    const int sensor = mj_name2id(model.get(), mjOBJ_SENSOR, (robot + "/encoder").c_str());
    EXPECT_EQ(model->sensor_objid[sensor], mj_name2id(model.get(), mjOBJ_JOINT, (robot + "/shoulder").c_str()));
    const int geom = mj_name2id(model.get(), mjOBJ_GEOM, (robot + "/lower").c_str());
    EXPECT_EQ(model->geom_matid[geom], mj_name2id(model.get(), mjOBJ_MATERIAL, (robot + "/steel").c_str()));
  }
  EXPECT_EQ(model->nkey, 0) << "keyframes have the size of their file's world";
}

TEST(Compose, DefaultsApplyOnlyToTheirFile) {
  const ScratchFolder scratch;
  const std::string scene = R"(<mujoco><compiler angle="radian"/>
<default><geom rgba="1 0 0 1"/><joint damping="3"/><default class="soft"><geom rgba="0 1 0 1"/></default></default>
<worldbody><geom name="of_scene" size="0.1"/><geom name="soft" class="soft" size="0.1"/>
<body childclass="soft"><geom name="child" size="0.1"/></body></worldbody></mujoco>)";
  const std::string robot = R"(<mujoco><compiler angle="radian"/>
<default><geom rgba="0 0 1 1"/></default>
<worldbody><body name="b"><joint name="j"/><geom name="g" size="0.1"/></body></worldbody></mujoco>)";
  const auto model = load_model(compose_texts(scratch, scene, {{"r", robot}}));
  const auto colour = [&](const char* geom) {
    const float* rgba = model->geom_rgba + 4 * mj_name2id(model.get(), mjOBJ_GEOM, geom);
    return Eigen::Vector3f(rgba[0], rgba[1], rgba[2]);
  };
  EXPECT_EQ(colour("of_scene"), Eigen::Vector3f(1, 0, 0));
  EXPECT_EQ(colour("soft"), Eigen::Vector3f(0, 1, 0));
  EXPECT_EQ(colour("child"), Eigen::Vector3f(0, 1, 0));
  EXPECT_EQ(colour("r/g"), Eigen::Vector3f(0, 0, 1));
  EXPECT_EQ(model->dof_damping[0], 0) << "the scene's joint default was applied to the robot";
}

TEST(Compose, OptionsAreTheScenes) {
  const ScratchFolder scratch;
  const std::string scene = R"(<mujoco><compiler angle="radian"/><option gravity="0 0 -1.5"/></mujoco>)";
  std::string robot = kBlock;
  robot.insert(robot.find("<worldbody>"), "<option gravity='0 0 9'/><statistic extent='77'/>");
  const auto model = load_model(compose_texts(scratch, scene, {{"r", robot}}));
  EXPECT_EQ(model->opt.gravity[2], -1.5);
  EXPECT_NE(model->stat.extent, 77);
}

TEST(Compose, SceneMayReferToRobots) {
  const ScratchFolder scratch;
  const std::string scene = R"(<mujoco><compiler angle="radian"/>
<worldbody><body name="bar"><freejoint/><geom size="0.1"/></body></worldbody>
<equality><weld body1="r/b" body2="bar"/></equality>
<sensor><jointpos name="travel" joint="r/j"/></sensor></mujoco>)";
  const auto model = load_model(compose_texts(scratch, scene, {{"r", kBlock}}));
  EXPECT_EQ(model->neq, 1);
  EXPECT_GE(mj_name2id(model.get(), mjOBJ_SENSOR, "travel"), 0);
}

TEST(Compose, FindsIncludesAndMeshesBesideTheirFile) {
  const ScratchFolder scratch;
  scratch.write("parts/meshes/wedge.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  scratch.write("parts/shapes.xml", R"(<mujoco><asset><mesh file="wedge.obj"/></asset></mujoco>)");
  const auto robot = scratch.write("parts/robot.xml", R"(<mujoco><compiler angle="radian" meshdir="meshes"/>
<include file="shapes.xml"/>
<worldbody><body name="b"><joint name="j"/><geom name="g" type="mesh" mesh="wedge"/></body></worldbody></mujoco>)");
  const auto scene = scratch.write("elsewhere/scene.xml", kEmptyScene);
  const auto model =
      load_model(compose(scene, {{"left", robot, Pose::Identity(), false}, {"right", robot, Pose::Identity(), false}}));
  EXPECT_EQ(model->nmesh, 2);
  EXPECT_GE(mj_name2id(model.get(), mjOBJ_MESH, "right/wedge"), 0);
}

TEST(Compose, ForceTorqueIsAddedOnTheWristOnceAndOnlyIfMounted) {
  const auto count = [](bool mounted, const std::filesystem::path& robot) {
    const auto model = load_model(compose(kData / "scene.xml", {{"arm", robot, Pose::Identity(), mounted}}));
    int sensors = 0;
    for (int i = 0; i < model->nsensor; ++i) {
      const std::string name = model->names + model->name_sensoradr[i];
      if (name == "arm/force_torque/force" || name == "arm/force_torque/torque") ++sensors;
    }
    return sensors;
  };
  EXPECT_EQ(count(false, kTwolink), 0);
  EXPECT_EQ(count(true, kTwolink), 2);

  const ScratchFolder scratch;
  std::string own = kBlock;
  own.insert(own.find("<geom"), "<site name='hand'/>");
  own.insert(own.find("</mujoco>"),
             "<sensor><torque name='force_torque/torque' site='hand'/><force name='force_torque/force' "
             "site='hand'/></sensor>");
  EXPECT_EQ(count(true, scratch.write("own.xml", own)), 2);
}

TEST(Compose, DifferentCompilerSettingsNameBothFiles) {
  const ScratchFolder scratch;
  const std::string message = message_of(scratch.path(), [&] {
    compose_texts(scratch, "<mujoco>\n<compiler/></mujoco>", {{"r", kBlock}});
  });
  EXPECT_EQ(message, "scene.xml:2: compiler.angle: \"degree\" differs from \"radian\" in " + scratch.path().string() +
                         "/robots/r.xml, expected <compiler angle=\"radian\"/> in every file");
}

TEST(Compose, SettingsEqualToTheDefaultDoNotDiffer) {
  const ScratchFolder scratch;
  std::string robot = kBlock;
  robot.replace(robot.find("/>"), 2, " eulerseq='xyz' autolimits='false'/>");
  EXPECT_NO_THROW(compose_texts(scratch, kEmptyScene, {{"r", robot}}));
}

TEST(Compose, SceneryIsAddedOnlyToASceneWithoutIt) {
  const ScratchFolder scratch;
  const auto bare = load_model(compose_texts(scratch, kEmptyScene));
  EXPECT_EQ(bare->nlight, 1);
  EXPECT_EQ(bare->ntex, 1);
  const auto own =
      load_model(compose_texts(scratch,
                               "<mujoco><asset><texture type='skybox' builtin='flat' width='8' height='48'/></asset>"
                               "<worldbody><light/><light/></worldbody></mujoco>"));
  EXPECT_EQ(own->nlight, 2);
  EXPECT_EQ(own->ntex, 1);
}

}  // namespace
}  // namespace mrroc::sim::compose_test
