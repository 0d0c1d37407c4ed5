// The joints of an IRb-6, because it has six.
#include "sim/ur/world_joints.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "mrroc/errors.hpp"
#include "robots/irb6/irb6_model.hpp"
#include "sim/simulation.hpp"
#include "sim/worlds.hpp"

namespace mrroc::sim::ur::world_joints_test {
namespace {

constexpr double kTime = 0.002;

RobotParameters regulated() {
  RobotParameters robot = load_irb6().front()->parameters();
  robot.drives = {DriveParameters::Interface::position, 10, 5};
  return robot;
}

config::Deployment one_robot() {
  config::Deployment deployment;
  deployment.file = kData / "test.toml";
  deployment.sim.emplace();
  deployment.sim->scene = kData / "scene.xml";
  config::RobotEntry robot;
  robot.name = "left";
  robot.type = "irb6";
  robot.driver.world = true;
  robot.base = at(0, 0, 0.7);
  deployment.robots.push_back(robot);
  return deployment;
}

/// A controller and a world with the same period.
struct InWorld {
  explicit InWorld(const config::Deployment& deployment = one_robot()) : simulation(deployment, *memory) {
    simulation.publish_initial();
    joints = std::make_unique<WorldJoints>(regulated(), *memory, 0);
  }

  void run(int periods, const std::function<JointTargets()>& targets) {
    for (int i = 0; i < periods; ++i) {
      joints->step(targets(), kTime);
      simulation.step(++now);
    }
    joints->step(targets(), kTime);
  }

  std::unique_ptr<world::WorldMemory> memory = std::make_unique<world::WorldMemory>();
  Simulation simulation;
  std::unique_ptr<WorldJoints> joints;
  Tick now = 0;
};

TEST(WorldJoints, StartWhereTheRobotIs) {
  const InWorld world;
  const JointVector home = regulated().home;
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_NEAR(world.joints->position()[i], home[static_cast<Eigen::Index>(i)], 1e-9);
}

TEST(WorldJoints, FollowPositionsAgainstGravity) {
  InWorld world;
  Six target = world.joints->position();
  const Six begin = target;
  world.run(500, [&] {
    target[1] += 0.0002;
    return JointTargets{JointTargets::Kind::position, target, {}};
  });
  EXPECT_NEAR(world.joints->velocity()[1], 0.1, 5e-3);
  world.run(500, [&] { return JointTargets{JointTargets::Kind::position, target, {}}; });
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(world.joints->position()[i], target[i], 1e-3) << i;
    EXPECT_NEAR(target[i], begin[i] + (i == 1 ? 501 * 0.0002 : 0), 1e-6) << i;
  }
}

TEST(WorldJoints, FollowVelocities) {
  InWorld world;
  world.run(300, [] { return JointTargets{JointTargets::Kind::velocity, {}, Six{0.2}}; });
  EXPECT_NEAR(world.joints->velocity()[0], 0.2, 5e-3);
  EXPECT_NEAR(world.joints->velocity()[1], 0, 5e-3);
}

TEST(WorldJoints, BrakesHold) {
  InWorld world;
  const Six begin = world.joints->position();
  world.run(300, [] { return JointTargets{}; });
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(world.joints->position()[i], begin[i], 1e-3) << i;
}

constexpr const char* kWiredScene = R"(<mujoco><compiler angle="radian"/>
<worldbody>
  <body name="valve" pos="3 0 0">
    <joint name="valve" type="slide" limited="true" range="0 1" damping="20"/>
    <geom size="0.01" mass="0.1"/>
  </body>
</worldbody>
<actuator><position name="left/output_3" joint="valve" kp="100" ctrllimited="true" ctrlrange="0 1"/></actuator>
<sensor><jointpos name="left/input_12" joint="valve"/><jointpos name="left/analog_input_0" joint="valve"/></sensor>
</mujoco>)";

TEST(WorldJoints, TerminalsAreWiredToTheWorld) {
  const task_test::ScratchFolder folder;
  config::Deployment deployment = one_robot();
  deployment.sim->scene = folder.write("scene.xml", kWiredScene);
  InWorld world(deployment);
  EXPECT_FALSE(world.joints->inputs()->on(12));
  ControllerIo outputs;
  outputs.set(3, true);
  world.joints->set_outputs(outputs);
  world.run(1000, [] { return JointTargets{}; });
  EXPECT_TRUE(world.joints->inputs()->on(12));
  EXPECT_GT(world.joints->inputs()->analog[0], 0.1);
}

/// A robot with a sensor inside its simulated controller.
config::Deployment measuring() {
  config::Deployment deployment = one_robot();
  config::SensorEntry wrist;
  wrist.name = "wrist";
  wrist.type = "force_torque";
  wrist.robot = "left";
  wrist.source = "ur";
  wrist.driver.emplace();
  wrist.driver->controller = "ur";
  wrist.driver->simulated = true;
  deployment.sensors.push_back(wrist);
  return deployment;
}

TEST(WorldJoints, TheFlangeCarriesTheForcesOnTheToolWithoutTheArmsOwnWeight) {
  InWorld world(measuring());
  world.run(200, [] { return JointTargets{}; });
  const Flange free = world.joints->flange();
  EXPECT_LT(free.load.norm(), 0.01) << free.load.transpose();
  const mjModel& model = world.simulation.world().model();
  const int site = mj_name2id(&model, mjOBJ_SITE, "left/wrist");
  const mjData& data = world.simulation.world().data();
  EXPECT_NEAR(free.pose.translation().z(), data.site_xpos[3 * site + 2] - 0.7, 1e-9) << "in the base frame";
  // 20 N upwards on the tool, at its centre of mass
  const int tool = model.site_bodyid[site];
  world.simulation.world().data().xfrc_applied[6 * tool + 2] = 20;
  world.run(200, [] { return JointTargets{}; });
  const Flange pushed = world.joints->flange();
  const Eigen::Vector3d force = pushed.pose.linear() * pushed.load.head<3>();
  EXPECT_NEAR(force.z(), 20, 0.05);
  EXPECT_NEAR(force.head<2>().norm(), 0, 0.05);
  const Eigen::Vector3d centre(data.xipos[3 * tool], data.xipos[3 * tool + 1], data.xipos[3 * tool + 2] - 0.7);
  const Eigen::Vector3d torque = pushed.pose.linear() * pushed.load.tail<3>();
  EXPECT_LT((torque - (centre - pushed.pose.translation()).cross(Eigen::Vector3d(0, 0, 20))).norm(), 0.05);
}

TEST(WorldJoints, RejectsInvalidArguments) {
  auto memory = std::make_unique<world::WorldMemory>();
  RobotParameters robot = regulated();
  robot.drives.bandwidth = 0;
  EXPECT_THROW(WorldJoints(robot, *memory, 0), SystemError);
  robot = regulated();
  robot.axes.pop_back();
  EXPECT_THROW(WorldJoints(robot, *memory, 0), SystemError);
}

}  // namespace
}  // namespace mrroc::sim::ur::world_joints_test
