#include "cli/panel/world_view.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <random>

#include "cli/operator/watching/telemetry_feed.hpp"
#include "cli/operator/watching/world_feed.hpp"
#include "cli/panel/scene.hpp"
#include "config/robot_parameters_file.hpp"
#include "config/table.hpp"
#include "mrroc/testing/scratch_folder.hpp"
#include "sim/simulation.hpp"

namespace mrroc::cli::world_view_test {
namespace {

using Json = nlohmann::json;

constexpr double kTolerance = 1e-5;  // of the numbers in a pose

config::Deployment task(const std::string& name) {
  return config::load_deployment(MRROC_SOURCE_DIR "/tasks/" + name + "/" + name + ".toml");
}

/// The event of a robot at `joints`.
std::string event_of(const config::RobotEntry& robot, const JointVector& joints, Tick tick) {
  RobotState state;
  state.tick = tick;
  state.joints = state.desired_joints = joints;
  state.joint_velocity = state.motors = state.current = JointVector::Zero(joints.size());
  return robot_event(robot.name, state);
}

/// Where body `name` is, in the field of an event "poses".
Eigen::Vector3d position_of(const mjModel& model, const Json& poses, const char* field, const std::string& name) {
  const int body = mj_name2id(&model, mjOBJ_BODY, name.c_str());
  EXPECT_GE(body, 0) << name;
  const auto number = [&](int i) { return poses.at(field).at(static_cast<std::size_t>(7 * body + i)).get<double>(); };
  return {number(0), number(1), number(2)};
}

/// The simulated world and its view have the same bodies at the same places, tick by tick.
TEST(WorldViewTest, ShowsTheSimulatedWorld) {
  const config::Deployment deployment = task("press");
  const auto memory = std::make_unique<world::WorldMemory>();
  sim::Simulation simulation(deployment, *memory);
  simulation.publish_initial();
  WorldFeed feed(memory.get());
  WorldView view(deployment);
  EXPECT_FALSE(feed.take().has_value()) << "no client watches";
  feed.watch(true);
  for (Tick tick = 1; tick <= 100; ++tick) {
    simulation.step(tick);
    const std::optional<std::string> event = feed.take();
    ASSERT_TRUE(event.has_value());
    EXPECT_FALSE(feed.take().has_value()) << "only new states";
    view.take(*event);
    ASSERT_TRUE(view.changed());
    const Json poses = Json::parse(view.poses());
    EXPECT_FALSE(view.changed());
    EXPECT_EQ(poses.at("tick"), tick);
    const mjModel& model = simulation.world().model();
    const mjData& data = std::as_const(simulation.world()).data();
    for (int i = 0; i < model.nbody; ++i) {
      const Eigen::Vector3d there(data.xpos[3 * i], data.xpos[3 * i + 1], data.xpos[3 * i + 2]);
      const Eigen::Vector3d shown = position_of(view.model(), poses, "bodies", model.names + model.name_bodyadr[i]);
      ASSERT_LT((there - shown).norm(), 2 * kTolerance) << model.names + model.name_bodyadr[i] << ", tick " << tick;
    }
  }
  feed.watch(false);
  simulation.step(101);
  EXPECT_FALSE(feed.take().has_value());
  feed.watch(true);
  simulation.step(102);  // this watcher leaves before it takes the state
  feed.watch(false);
  feed.watch(true);
  EXPECT_FALSE(feed.take().has_value()) << "of the last watcher's time";
  simulation.step(103);
  EXPECT_TRUE(feed.take().has_value());
}

/// Robots with any hardware, by their joints alone: the tool is where MuJoCo's kinematics of the robot's own file say.
TEST(WorldViewTest, ShowsRobotsByTheirJoints) {
  std::mt19937_64 random(1);
  std::printf("seed 1\n");
  const task_test::ScratchFolder folder;
  for (const char* hardware : {"loopback", "mujoco"}) {
    const bool simulated = std::string{hardware} == "mujoco";
    folder.write("two.toml", std::string{"[deployment]\nname = \"two\"\n"
                                         "[robots.left]\ntype = \"irb6\"\nposition = [0, 0.8, 0.7]\nhardware = \""} +
                                 hardware +
                                 "\"\n[robots.right]\ntype = \"irb6\"\nposition = [0.5, -0.8, 0.7]\n"
                                 "rotation = [0, 0, 1.5]\nhardware = \"" +
                                 hardware + "\"\n" +
                                 (simulated ? "[sim]\nscene = \"" MRROC_SOURCE_DIR "/robots/irb6/demo.xml\"\n" : ""));
    const config::Deployment deployment = config::load_deployment(folder.path() / "two.toml");
    WorldView view(deployment);
    for (int round = 0; round < 50; ++round) {
      const config::RobotEntry& robot = deployment.robots[static_cast<std::size_t>(round % 2)];
      const RobotParameters parameters = config::read_robot_parameters(config::Table::load(robot.files().parameters));
      JointVector joints(std::ssize(parameters.axes));
      for (Eigen::Index i = 0; i < joints.size(); ++i) {
        const AxisParameters& axis = parameters.axes[static_cast<std::size_t>(i)];
        joints[i] = std::uniform_real_distribution(axis.position_min, axis.position_max)(random);
      }
      view.take(event_of(robot, joints, static_cast<Tick>(round + 1)));
      const Json poses = Json::parse(view.poses());
      const sim::Data data = sim::make_data(view.model());
      for (std::size_t i = 0; i < parameters.axes.size(); ++i) {
        const std::string name = robot.name + "/" + parameters.axes[i].name;
        const int joint = mj_name2id(&view.model(), mjOBJ_JOINT, name.c_str());
        ASSERT_GE(joint, 0) << name;
        data->qpos[view.model().jnt_qposadr[joint]] = joints[static_cast<Eigen::Index>(i)];
      }
      mj_kinematics(&view.model(), data.get());
      const int tool = view.model().site_bodyid[mj_name2id(&view.model(), mjOBJ_SITE, (robot.name + "/tool").c_str())];
      const std::string body = view.model().names + view.model().name_bodyadr[tool];
      const Eigen::Vector3d there(data->xpos[3 * tool], data->xpos[3 * tool + 1], data->xpos[3 * tool + 2]);
      for (const char* field : {"bodies", "desired"})
        ASSERT_LT((there - position_of(view.model(), poses, field, body)).norm(), 2 * kTolerance) << field;
    }
  }
}

TEST(WorldViewTest, IgnoresWhatItDoesNotUnderstand) {
  const config::Deployment deployment = task("press");
  WorldView view(deployment);
  const std::string before = view.poses();
  for (const char* event :
       {"", "{", "[]", "1", R"({"event":"robot"})", R"({"event":"robot","name":"other","tick":1,"joints":[1]})",
        R"({"event":"world","tick":1,"positions":[1,2],"mocap_positions":[],"mocap_quaternions":[]})",
        R"({"event":"world","tick":1,"positions":"all"})", R"({"event":"message","text":"robot"})"})
    view.take(event);
  EXPECT_EQ(Json::parse(view.poses()).at("bodies"), Json::parse(before).at("bodies"));
}

TEST(SceneTest, DescribesTheComposedWorld) {
  const config::Deployment deployment = task("press");
  const WorldView view(deployment);
  const Json scene = Json::parse(scene_json(&view.model(), deployment));
  EXPECT_EQ(scene.at("deployment"), "press");
  EXPECT_EQ(scene.at("bodies").size(), static_cast<std::size_t>(view.model().nbody));
  EXPECT_EQ(scene.at("frames").size(), static_cast<std::size_t>(view.model().nsite));
  const Json& arm = scene.at("robots").at(0);
  EXPECT_EQ(arm.at("name"), "arm");
  EXPECT_EQ(arm.at("axes").size(), 6U);
  EXPECT_EQ(arm.at("axes").at(0).at("unit"), "rad");
  EXPECT_EQ(arm.at("postures"), Json::parse(R"(["home","raised"])"));
  EXPECT_EQ(arm.at("tools"), Json::parse(R"(["flange","standard"])"));
  EXPECT_EQ(scene.at("frames").at(arm.at("tool_frame").get<std::size_t>()).at("name"), "arm/tool");
  EXPECT_EQ(scene.at("sensors").at(0).at("channels").size(), 6U);
  for (const Json& geom : scene.at("geoms")) {
    ASSERT_LT(geom.at("body").get<int>(), view.model().nbody);
    ASSERT_EQ(geom.at("size").size(), 3U);
    ASSERT_EQ(geom.at("quaternion").size(), 4U);
  }
}

TEST(SceneTest, RobotsAreThereWithoutTheWorld) {
  const Json scene = Json::parse(scene_json(nullptr, task("press")));
  EXPECT_EQ(scene.at("robots").at(0).at("axes").size(), 6U);
  EXPECT_TRUE(scene.at("robots").at(0).at("tool_frame").is_null());
  EXPECT_TRUE(scene.at("geoms").empty());
}

TEST(SceneTest, SlidingAxesAreInMetres) {
  const config::Deployment deployment = task("track_and_pick");
  const WorldView view(deployment);
  const Json scene = Json::parse(scene_json(&view.model(), deployment));
  bool slides = false;
  for (const Json& robot : scene.at("robots"))
    for (const Json& axis : robot.at("axes")) slides = slides || axis.at("unit") == "m";
  EXPECT_TRUE(slides) << "its belt";
}

}  // namespace
}  // namespace mrroc::cli::world_view_test
