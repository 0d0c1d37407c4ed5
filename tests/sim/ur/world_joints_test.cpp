// The joints of an IRb-6, because it has six.
#include "sim/ur/world_joints.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "mrroc/errors.hpp"
#include "robots/irb6/irb6_model.hpp"
#include "sim/simulation.hpp"
#include "sim/worlds.hpp"

namespace mrroc::sim::ur {
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
  InWorld() : simulation(one_robot(), *memory) {
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
}  // namespace mrroc::sim::ur
